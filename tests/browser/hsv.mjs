// node hsv.mjs SITE PAGE PICTURE: turns the hue ring of a page that holds the HSV view alone, then
// gives it pictures in every way there is, and prints what happened. test_hsv_view.py judges it.

import { readFileSync } from "node:fs";

import { main, openPage, waitForFrames } from "../../tools/browser.mjs";

await main(async (browser, site, name, picturePath) => {
  const { page, complaints } = await openPage(browser, site, name);
  await page.waitForSelector(".explorer[data-state=ready]");
  const first = await read(page);
  const drawn = await show(page, first.values.centroid);
  const ring = await turnRing(page);
  await page.getByRole("button", { name: "Reset" }).click();
  const own = await givePictures(page, readFileSync(picturePath));
  const camera = await useCamera(page);
  await page.locator("canvas").press("ArrowRight");
  const picked = await read(page);
  await press(page, "Back to scene");
  const last = await read(page);
  return { first, drawn, ring, own, camera, picked, last, complaints: [...complaints] };
});

/** What the explorer says and shows, once it is drawn. */
async function read(page) {
  await waitForFrames(page);
  return page.evaluate(() => {
    const root = document.querySelector(".explorer");
    const { width, height } = root.querySelector("canvas");
    return {
      values: JSON.parse(root.dataset.values),
      picture: root.dataset.picture,
      size: [width, height],
      place: root.getBoundingClientRect().height,
      traits: window.host.traits(),
      message: root.querySelector(".explorer-own [role=status]").textContent,
      buttons: [...root.querySelectorAll(".explorer-own button:not([hidden])")].map(
        (one) => one.textContent,
      ),
      focused: document.activeElement.textContent,
    };
  });
}

function press(page, name) {
  return page.getByRole("button", { name }).press("Enter");
}

/** Colors of a pixel inside, one outside, the last one and the centroid, for each way to show. */
async function show(page, centroid) {
  const seen = [];
  for (const shown of [0, 1, 2]) {
    await page.evaluate((value) => window.host.set("shown", value), shown);
    await read(page);
    seen.push(
      await page.evaluate(
        (places) => {
          const context = document.querySelector("canvas").getContext("2d");
          return places.map(([x, y]) => [...context.getImageData(x, y, 1, 1).data]);
        },
        [[32, 22], [5, 5], [159, 119], centroid],
      ),
    );
  }
  return seen;
}

async function turnRing(page) {
  const seen = {};
  const note = async (step) => {
    const { traits } = await read(page);
    const ends = await page.$$eval(".explorer-dial [role=slider]", (all) =>
      all.map((one) => Number(one.getAttribute("aria-valuenow"))),
    );
    const lit = await page.locator(".explorer-dial path.lit").count();
    seen[step] = { traits: [traits.hue_from, traits.hue_to], ends, lit };
  };
  await note("start");
  for (const key of [
    "ArrowRight",
    "ArrowUp",
    "PageUp",
    "Home",
    "ArrowLeft",
    "PageDown",
    "End",
    "x",
  ]) {
    await page.getByRole("slider", { name: "hue from, on the ring" }).press(key);
    await note(key);
  }
  await page.locator(".explorer-dial").scrollIntoViewIfNeeded();
  const dial = await page.locator(".explorer-dial").boundingBox();
  const at = (hue, radius) => [
    dial.x + dial.width * (0.5 + (radius / 240) * Math.sin((hue / 90) * Math.PI)),
    dial.y + dial.height * (0.5 - (radius / 240) * Math.cos((hue / 90) * Math.PI)),
  ];
  await page.mouse.move(...at(6, 74));
  await page.mouse.down();
  await page.mouse.move(...at(45, 80), { steps: 4 });
  await page.mouse.move(...at(100, 120), { steps: 4 });
  await page.mouse.up();
  await note("drag the inner end");
  await page.mouse.move(...at(20, 90)); // the button is up: nothing is held
  await note("move on");
  await page.mouse.click(...at(165, 88));
  await note("click on the ring");
  await page.mouse.click(...at(50, 20));
  await note("click in the middle");
  return seen;
}

async function givePictures(page, buffer) {
  const seen = { before: await read(page) };
  const choose = (file) => page.setInputFiles("input[type=file]", file);
  const told = (text) =>
    page.locator(".explorer-own [role=status]").filter({ hasText: text }).waitFor();
  await choose({ name: "own.png", mimeType: "image/png", buffer });
  await told("your picture");
  seen.file = await read(page);
  await choose({ name: "words.png", mimeType: "image/png", buffer: Buffer.from("words") });
  await told("words.png");
  seen.broken = await read(page);
  await press(page, "Back to scene");
  seen.back = await read(page);
  const transfer = await page.evaluateHandle(
    (bytes) => {
      const data = new DataTransfer();
      data.items.add(new File([Uint8Array.from(bytes)], "own.png", { type: "image/png" }));
      return data;
    },
    [...buffer],
  );
  const drop = (type) =>
    page.dispatchEvent(".explorer-hsv-picture", type, { dataTransfer: transfer });
  await drop("dragover");
  seen.dropping = await page.locator(".explorer-hsv-picture.dropping").count();
  await drop("drop");
  await told("your picture");
  seen.dropped = await read(page);
  await press(page, "Back to scene");
  await page.evaluate((clipboardData) => {
    const options = { clipboardData, bubbles: true, cancelable: true };
    document.querySelector("canvas").dispatchEvent(new ClipboardEvent("paste", options));
  }, transfer);
  await told("your picture");
  seen.pasted = await read(page);
  return seen;
}

/** A camera that films a green wall, and one the reader does not allow. */
async function useCamera(page) {
  await page.evaluate(() => {
    const canvas = Object.assign(document.createElement("canvas"), { width: 1280, height: 720 });
    const context = canvas.getContext("2d");
    window.tracks = [];
    navigator.mediaDevices.getUserMedia = async () => {
      const stream = canvas.captureStream();
      const film = setInterval(() => {
        context.fillStyle = "#00ff00";
        context.fillRect(0, 0, 1280, 720);
        if (stream.getTracks().every((one) => one.readyState === "ended")) clearInterval(film);
      }, 20);
      window.tracks.push(...stream.getTracks());
      return stream;
    };
  });
  const states = () => page.evaluate(() => window.tracks.map((one) => one.readyState));
  const filming = () =>
    page.waitForFunction(() => document.querySelector("video")?.readyState >= 2);
  const seen = {};
  await press(page, "Camera");
  await filming();
  seen.on = await read(page);
  seen.onTracks = await states();
  await press(page, "Take the picture");
  seen.taken = await read(page);
  await press(page, "Camera");
  await filming();
  await press(page, "Cancel");
  seen.canceled = await read(page);
  // canceled while the browser still asks: the camera that comes late is switched off again
  await page.evaluate(() => {
    const open = navigator.mediaDevices.getUserMedia;
    navigator.mediaDevices.getUserMedia = () =>
      new Promise((done) => (window.allow = async () => done(await open())));
  });
  await press(page, "Camera");
  await press(page, "Cancel");
  await page.evaluate(() => window.allow());
  await page.waitForFunction(() => window.tracks.length === 3);
  seen.late = await read(page);
  seen.tracks = await states();
  seen.videos = await page.locator("video").count();
  for (const [step, name] of [
    ["denied", "NotAllowedError"],
    ["strange", "OverconstrainedError"],
  ]) {
    await page.evaluate((error) => {
      navigator.mediaDevices.getUserMedia = () =>
        Promise.reject(new DOMException("no such thing", error));
    }, name);
    await press(page, "Camera");
    await page.locator(".explorer-own [role=status]").filter({ hasText: "camera" }).waitFor();
    await page.waitForFunction(
      () =>
        !document.querySelector(".explorer-own [role=status]").textContent.startsWith("Waiting"),
    );
    seen[step] = await read(page);
  }
  return seen;
}
