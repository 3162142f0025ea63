// What scripts find on a page, beside what every browser has.

interface Window {
  /** Put there by the book and its libraries. */
  cameraLab: any;
  axe: any;
  /** Put there by the tests. */
  seenWords: any;
  said: any;
  seenStatus: any;
  said: string[];
  host: any;
  tracks: any;
  allow: any;
  cleanUp: any;
}
declare const host: any;
/** A selector does not say which kind of element it finds. */
interface ParentNode {
  querySelector(selector: string): any;
  querySelectorAll(selector: string): NodeListOf<any>;
}
