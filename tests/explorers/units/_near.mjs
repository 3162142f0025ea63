// What the unit tests share.

import assert from "node:assert/strict";

/** Numbers, or lists of them, agree to a billionth. */
export function assertNear(found, expected, tolerance = 1e-9) {
  if (!Array.isArray(expected)) {
    const off = Math.abs(found - expected);
    assert.ok(off <= tolerance, `expected ${expected}, got ${found}`);
    return;
  }
  assert.equal(found.length, expected.length);
  for (const [i, one] of expected.entries()) assertNear(found[i], one, tolerance);
}
