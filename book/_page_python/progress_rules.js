// biome-ignore-all format: written by a tool
// Written by `make exercises` from labutils, see tools/derive/shared.py: change it there.
// What a progress file may hold; progress.js reads it.
window.cameraLab = { ...window.cameraLab, rules: {
 "FILE_NAME": "labutils-progress.json",
 "VERSION": 1,
 "MAX_HINTS": 3,
 "MAX_CHARACTERS": 1000000,
 "SCHEMA": {
  "type": [
   "object"
  ],
  "required": [
   "version",
   "exercises"
  ],
  "properties": {
   "version": {
    "type": [
     "integer"
    ],
    "minimum": 1,
    "maximum": 1
   },
   "exercises": {
    "type": [
     "object"
    ],
    "additionalProperties": {
     "type": [
      "object"
     ],
     "required": [
      "passed",
      "attempts",
      "hints",
      "last_property",
      "mistakes"
     ],
     "properties": {
      "passed": {
       "type": [
        "boolean"
       ]
      },
      "attempts": {
       "type": [
        "integer"
       ],
       "minimum": 0
      },
      "hints": {
       "type": [
        "integer"
       ],
       "minimum": 0,
       "maximum": 3
      },
      "last_property": {
       "type": [
        "string",
        "null"
       ]
      },
      "mistakes": {
       "type": [
        "object"
       ],
       "additionalProperties": {
        "type": [
         "integer"
        ],
        "minimum": 0
       }
      },
      "relations": {
       "type": [
        "object"
       ],
       "additionalProperties": {
        "type": [
         "integer"
        ],
        "minimum": 0
       }
      },
      "probes": {
       "type": [
        "object"
       ],
       "additionalProperties": {
        "type": [
         "integer"
        ],
        "minimum": 0
       }
      }
     }
    }
   },
   "predictions": {
    "type": [
     "object"
    ],
    "additionalProperties": {
     "type": [
      "object"
     ],
     "required": [
      "said",
      "right"
     ],
     "properties": {
      "said": {
       "type": [
        "string",
        "null"
       ]
      },
      "right": {
       "type": [
        "boolean"
       ]
      }
     }
    }
   }
  }
 },
 "WORDS": {
  "object": "an object",
  "array": "a list",
  "string": "a text",
  "boolean": "true or false",
  "integer": "a whole number",
  "number": "a number",
  "null": "null"
 }
} };
