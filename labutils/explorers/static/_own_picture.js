// The reader's own picture: from a file, dropped, pasted, or from the camera. It is read in this
// page and kept in this page: nothing here sends, and no trait holds it.

import { getContext, make } from "./_frame.js";
import { openWebcam } from "./_webcam.js";

const LEAST_SIDE = 32; // pixels that a long and narrow picture keeps of its short side

/**
 * Add the buttons at the foot of the frame. `show` gets a picture, at most of `size`, or null for the scene's;
 * `place` is where the camera shows what it sees.
 * @param {OwnPictureParts} parts
 */
export function acceptPictures({ frame, place, size, show }) {
  const bar = make("div", "explorer-own", frame.foot);
  /**
   * @param {string} text
   * @param {() => void} act
   */
  const addButton = (text, act) => {
    const button = make("button", "explorer-button", bar);
    button.type = "button";
    button.textContent = text;
    button.addEventListener("click", act);
    return button;
  };
  const chooser = make("input", "", bar);
  Object.assign(chooser, { type: "file", accept: "image/*", hidden: true });
  const choose = addButton("Open picture", () => chooser.click());
  const camera = addButton("Camera", () => webcam.start());
  const take = addButton("Take the picture", () => webcam.take());
  const cancel = addButton("Cancel", () => {
    webcam.stop();
    say("");
  });
  const back = addButton("Back to scene", () => {
    latest++;
    show(null);
    say("");
    own = false;
    back.hidden = true;
    choose.focus();
  });
  const notes = make("div", "explorer-own-notes", bar);
  make("p", "explorer-own-note", notes).textContent =
    "Your picture stays on this page. You may also drop or paste one.";
  const message = make("p", "explorer-own-note", notes);
  message.setAttribute("role", "status");
  const say = (/** @type {string} */ text) => {
    message.textContent = text;
  };

  let own = false;
  let latest = 0; // a large file may be ready after a small one that was opened later
  const accept = (/** @type {HTMLVideoElement | ImageBitmap} */ source) => {
    show(shrinkPicture(source, size));
    say("This is your picture.");
    own = true;
    back.hidden = false;
  };
  const read = async (/** @type {File} */ file) => {
    webcam.stop();
    const mine = ++latest;
    const bitmap = await createImageBitmap(file).catch(() => null);
    if (mine === latest) {
      if (bitmap) accept(bitmap);
      else say(`${file.name || "This"} cannot be read as a picture.`);
    }
    bitmap?.close();
  };
  const webcam = openWebcam(place, {
    say,
    accept(video) {
      latest++;
      accept(video);
    },
    onChange(running) {
      const active = /** @type {HTMLElement | null} */ (document.activeElement);
      choose.hidden = running;
      camera.hidden = running || !navigator.mediaDevices?.getUserMedia;
      take.hidden = cancel.hidden = !running;
      back.hidden = running || !own;
      // a button that vanishes would take the focus with it
      if (active?.hidden && bar.contains(active)) (running ? take : camera).focus();
    },
  });

  chooser.addEventListener("change", () => {
    if (chooser.files?.length) read(chooser.files[0]);
    chooser.value = ""; // so that the same file may be opened again
  });
  frame.root.addEventListener("paste", (event) => {
    const file = findPicture(event.clipboardData);
    if (!file) return;
    event.preventDefault();
    read(file);
  });
  dropOn(frame.root, place, read);
  frame.cleanups.push(() => {
    latest++;
    webcam.stop();
  });
}

/** @param {DataTransfer | null} transfer */
function findPicture(transfer) {
  return [...(transfer?.files ?? [])].find((file) => file.type.startsWith("image/"));
}

/**
 * Read a file dropped anywhere on `target`: beside it the browser would open the file instead.
 * @param {HTMLElement} target
 * @param {HTMLElement} place
 * @param {(file: File) => void} read
 */
function dropOn(target, place, read) {
  const light = (/** @type {boolean} */ on) => place.classList.toggle("dropping", on);
  target.addEventListener("dragover", (event) => {
    if (!event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    event.dataTransfer.dropEffect = "copy";
    light(true);
  });
  target.addEventListener("dragleave", (event) => {
    if (!target.contains(/** @type {Node | null} */ (event.relatedTarget))) light(false);
  });
  target.addEventListener("drop", (event) => {
    light(false);
    const file = findPicture(event.dataTransfer) ?? event.dataTransfer?.files[0];
    if (!file) return;
    event.preventDefault();
    event.stopPropagation();
    read(file);
  });
}

/**
 * How much smaller a picture becomes: it fits `size`, or is longer where it would lose its short side.
 * @param {{ width: number, height: number }} size
 * @param {number} width
 * @param {number} height
 */
function findScale(size, width, height) {
  const fit = Math.min(1, size.width / width, size.height / height);
  const sameArea = Math.sqrt((size.width * size.height) / (width * height));
  return Math.max(fit, Math.min(1, sameArea, LEAST_SIDE / Math.min(width, height)));
}

/**
 * Draw a picture or a frame of a video, made to fit `size`; transparent pixels become white.
 * @param {HTMLVideoElement | ImageBitmap} source
 * @param {{ width: number, height: number }} size
 * @returns {Picture}
 */
function shrinkPicture(source, size) {
  const [fullWidth, fullHeight] =
    "videoWidth" in source
      ? [source.videoWidth, source.videoHeight]
      : [source.width, source.height];
  const scale = findScale(size, fullWidth, fullHeight);
  const width = Math.max(1, Math.round(fullWidth * scale));
  const height = Math.max(1, Math.round(fullHeight * scale));
  const canvas = Object.assign(document.createElement("canvas"), { width, height });
  const context = getContext(canvas, { willReadFrequently: true });
  context.fillStyle = "#fff";
  context.fillRect(0, 0, width, height);
  context.imageSmoothingQuality = "high";
  context.drawImage(source, 0, 0, width, height);
  return { width, height, channels: 4, data: context.getImageData(0, 0, width, height).data };
}
