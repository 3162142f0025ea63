// A still from the reader's camera. It runs only between two clicks, and stops with the page.

import { make, toError } from "./_frame.js";

/** @type {Record<string, string>} */
const REASONS = {
  NotAllowedError: "The browser did not allow the camera. You can open a picture instead.",
  NotFoundError: "No camera was found. You can open a picture instead.",
  NotReadableError: "Another program uses the camera. Close it and try again.",
};

/**
 * Make { start, take, stop }; `accept` gets the video to draw, `onChange` whether it is running.
 * @param {HTMLElement} place
 * @param {WebcamParts} parts
 */
export function openWebcam(place, { say, accept, onChange }) {
  /** @type {MediaStream | null} */
  let stream = null;
  /** @type {HTMLVideoElement | null} */
  let video = null;
  let latest = 0; // the reader may cancel while the browser still asks for leave

  const stop = () => {
    latest++;
    for (const track of stream?.getTracks() ?? []) track.stop();
    video?.remove();
    stream = video = null;
    onChange(false);
  };
  onChange(false);
  return {
    stop,
    async start() {
      const mine = ++latest;
      say("Waiting for the camera.");
      onChange(true);
      try {
        const opened = await navigator.mediaDevices.getUserMedia({
          video: { facingMode: "environment", width: { ideal: 640 } },
        });
        if (mine !== latest) {
          for (const track of opened.getTracks()) track.stop();
          return;
        }
        stream = opened;
        video = make("video", "explorer-video", place);
        Object.assign(video, { srcObject: stream, muted: true, playsInline: true });
        video.setAttribute("aria-label", "What your camera sees");
        await video.play();
        say("The camera is on.");
      } catch (thrown) {
        if (mine !== latest) return;
        stop();
        const error = toError(thrown);
        say(REASONS[error.name] ?? `The camera does not start: ${error.message}`);
      }
    },
    take() {
      if (!video?.videoWidth) return; // no picture has come yet
      accept(video);
      stop();
    },
  };
}
