// node cloud.mjs SITE FOLDER: uses the point cloud explorer on a page that holds nothing else, once
// with WebGL and once in a browser that has none; pictures go into FOLDER. test_cloud_view.py
// says what is right.

import { launch } from "../../tools/browser.mjs";

const [site, folder] = process.argv.slice(2);
const FLAGS = { webgl2: [], "2d": ["--disable-gpu", "--disable-3d-apis"] };

const seen = {};
for (const [kind, flags] of Object.entries(FLAGS)) {
  const browser = await launch(flags);
  seen[kind] = await watch(await browser.newPage({ viewport: { width: 800, height: 900 } }), kind);
  await browser.close();
}
process.stdout.write(JSON.stringify(seen));

async function watch(page, kind) {
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  await page.goto(new URL("cloud.html", site).href);
  const root = page.locator(".explorer[data-state=ready]");
  await root.waitFor({ timeout: 10000 }).catch(() => {
    throw new Error(`the explorer never got ready: ${errors.join("; ")}`);
  });
  const surface = page.locator(".explorer-cloud-view");
  const settle = () =>
    page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done, 400))));
  const report = () =>
    page.evaluate(() => ({
      ...Object.fromEntries(
        ["fov_y_deg", "far", "color", "pixel", "orbit"].map((n) => [n, host.get(n)]),
      ),
      values: JSON.parse(document.querySelector(".explorer").dataset.values),
      text: document.querySelector(".explorer-readout").textContent,
      saves: host.saves,
    }));
  const shoot = async (name) => {
    await settle();
    await page.addStyleTag({ content: ".explorer-cloud-marks { visibility: hidden }" });
    await surface.screenshot({ path: `${folder}/${kind}-${name}.png` });
  };
  const result = { errors, painter: await root.getAttribute("data-painter") };
  await shoot("start");
  result.start = await report();
  const box = await surface.boundingBox();
  result.size = [box.width, box.height];
  const at = (x, y) => [box.x + x * box.width, box.y + y * box.height];

  await page.mouse.move(...at(0.5, 0.5));
  await page.mouse.wheel(0, -200);
  await settle();
  result.wheelUnasked = await report();
  result.scrolled = await page.evaluate(() => scrollY);

  result.clicks = [];
  for (const place of [
    [0.45, 0.6],
    [0.6, 0.62],
    [0.7, 0.4],
    [0.02, 0.02],
  ]) {
    await page.mouse.click(...at(...place));
    await settle();
    result.clicks.push({ place, ...(await report()) });
  }
  await page.mouse.wheel(0, -200);
  await settle();
  result.wheelFocused = await report();

  await page.mouse.move(...at(0.5, 0.5));
  await page.mouse.down();
  await page.mouse.move(...at(0.6, 0.5), { steps: 5 });
  result.midDrag = await report();
  await page.mouse.up();
  await settle();
  result.dragged = await report();

  result.keys = {};
  for (const key of ["ArrowLeft", "ArrowUp", "+", "-", "Home"]) {
    await page.keyboard.press(key);
    await settle();
    result.keys[key] = await report();
  }

  result.buttons = {};
  for (const name of [
    "zoom in",
    "zoom out",
    "view of the camera",
    "view from above",
    "view from the side",
  ]) {
    await page.getByRole("button", { name }).click();
    result.buttons[name] = await report();
    if (name === "view of the camera") await shoot("camera");
  }
  await page.locator(".explorer-picker canvas").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Shift+ArrowDown");
  await settle();
  result.pickedByKeys = await report();

  result.settings = [];
  for (const setting of [
    { fov_y_deg: 60, color: 2 },
    { far: 1.2, color: 1 },
    { fov_y_deg: 30, far: 0.9, pixel: [330, 215] },
  ]) {
    await page.evaluate((values) => {
      for (const [name, value] of Object.entries(values)) host.set(name, value);
    }, setting);
    await settle();
    result.settings.push(await report());
  }
  await shoot("near");
  await page.getByRole("button", { name: "Reset" }).click();
  await settle();
  result.reset = await report();

  // from behind the wall near and far change places, so the order of drawing is no longer right by luck
  await page.evaluate(() => {
    const orbit = host.get("start").orbit;
    host.set("orbit", { ...orbit, azimuth_deg: orbit.azimuth_deg + 180, elevation_deg: 10 });
  });
  await shoot("behind");
  await page.getByRole("button", { name: "Reset" }).click();

  if (kind === "webgl2") {
    await page.evaluate(() => {
      const gl = document.querySelector(".explorer-cloud-points").getContext("webgl2");
      gl.getExtension("WEBGL_lose_context").loseContext();
    });
    await page.locator(".explorer[data-painter='2d']").waitFor();
    await shoot("lost");
    await page.reload();
    await root.waitFor();
  }
  result.left = await page.evaluate(async () => {
    const canvas = document.querySelector(".explorer-cloud-points");
    const gl = canvas.getContext("webgl2");
    window.cleanUp();
    await new Promise((done) => setTimeout(done, 300));
    const parts = document.querySelectorAll(".explorer").length;
    return { parts, listeners: host.countListeners(), contextLost: gl ? gl.isContextLost() : true };
  });
  return result;
}
