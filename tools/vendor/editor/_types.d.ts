// What the bundler puts in; see tools/vendor/library_names.py.

declare module "library-names" {
  /** Module, or "python": its names, with blanks between them. */
  const names: Record<string, string>;
  export default names;
}
