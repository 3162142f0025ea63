// What Python in the page consists of, loaded once: every asset is one or more scripts, because a
// page that is opened from a file may load nothing else.
(() => {
  /** @type {PythonData} */
  const data = JSON.parse(document.getElementById("python-data")?.textContent ?? "");
  const base = new URL(data.base, document.baseURI).href;

  /** @type {Map<string, Promise<Blob>>} */
  const blobs = new Map(); // name of an asset: a promise of its content, gzipped
  /** @type {Record<string, (text: string) => void>} */
  const waiting = {}; // "name/piece": what to do when its script has come

  /** Every script of an asset calls this. */
  window.cameraLabAsset = (name, piece, text) => waiting[`${name}/${piece}`]?.(text);

  async function loadScript(/** @type {string} */ file) {
    const script = document.createElement("script");
    script.src = `${base}${file}?v=${data.version}`;
    /** @type {Promise<unknown>} */
    const loaded = new Promise((resolve, reject) => {
      script.onload = resolve;
      script.onerror = () => reject(new Error(`a file of this page could not be loaded: ${file}`));
    });
    document.head.append(script);
    await loaded.finally(() => script.remove());
  }

  /**
   * @param {string} name
   * @param {string} file
   * @param {number} piece
   */
  async function loadPiece(name, file, piece) {
    let text = "";
    waiting[`${name}/${piece}`] = (given) => {
      text = given;
    };
    await loadScript(file);
    delete waiting[`${name}/${piece}`];
    return (await fetch(`data:application/octet-stream;base64,${text}`)).blob();
  }

  /**
   * Load an asset once; what failed is tried again the next time.
   * @param {Asset} asset
   * @param {(bytes: number) => void} onLoaded
   */
  function load(asset, onLoaded = () => {}) {
    let whole = blobs.get(asset.name);
    if (!whole) {
      const pieces = asset.files.map(async (file, piece) => {
        const blob = await loadPiece(asset.name, file, piece);
        onLoaded(blob.size);
        return blob;
      });
      whole = Promise.all(pieces).then((parts) => new Blob(parts));
      whole.catch(() => blobs.delete(asset.name));
      blobs.set(asset.name, whole);
    }
    return whole;
  }

  /**
   * Load all assets of a part; returns their contents by name.
   * @param {string} part
   * @param {(bytes: number) => void} onLoaded
   * @returns {Promise<Record<string, Blob>>}
   */
  async function loadPart(part, onLoaded) {
    const assets = data.parts[part];
    const contents = await Promise.all(assets.map((asset) => load(asset, onLoaded)));
    return Object.fromEntries(assets.map((asset, i) => [asset.name, contents[i]]));
  }

  /** How many bytes a part has as it travels. */
  const countBytes = (/** @type {string} */ part) =>
    data.parts[part].reduce((sum, { bytes }) => sum + bytes, 0);

  async function inflateText(/** @type {Blob} */ blob) {
    return new Response(blob.stream().pipeThrough(new DecompressionStream("gzip"))).text();
  }

  const assets = { data, load, loadPart, loadScript, countBytes, inflateText };
  window.cameraLab = { ...window.cameraLab, assets };
})();
