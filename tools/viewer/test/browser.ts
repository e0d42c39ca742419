// Opens pages in Debian's Chromium without a window, drawing in software, and collects their faults.
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { after } from "node:test";
import { chromium, type Browser, type BrowserContextOptions, type Page } from "playwright-core";

const executablePath = process.env.TAMIS_CHROMIUM ?? "/usr/bin/chromium";
const pictures = process.env.TAMIS_SCREENSHOTS;

const launched: Browser[] = [];
// A browser opens all files in one page: with a page for each, each would have a process that starts with empty caches.
const pages = new Map<Browser, Page>();
const kViewport = { width: 960, height: 540 };

// A browser that a failing test leaves open would keep the tests from ending.
after(() => Promise.all(launched.map((browser) => browser.close())));

/** Starts a browser, which is closed after the last test of the file. */
export async function launch(...flags: string[]): Promise<Browser> {
  const args = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", ...flags];
  // Saves a third of the time to draw; no test looks at single pixels of an edge.
  args.push("--webgl-antialiasing-mode=none", "--disable-gpu-compositing");
  // A test may run as root in a container, where Chromium's sandbox cannot be set up.
  args.push("--no-sandbox");
  const browser = await chromium.launch({ executablePath, args });
  launched.push(browser);
  return browser;
}

export interface Opened {
  page: Page;
  /** Errors, warnings of the console, and requests that leave the file. */
  faults: string[];
}

async function emptyPage(browser: Browser, options?: BrowserContextOptions): Promise<Page> {
  const used = options ? undefined : pages.get(browser);
  const page = used ?? (await browser.newPage({ viewport: kViewport, reducedMotion: "reduce", ...options }));
  if (!options) pages.set(browser, page);
  for (const event of ["console", "pageerror", "request"]) page.removeAllListeners(event);
  if (used) await used.goto("about:blank");
  return page;
}

/**
 * Opens a file as a double click would, and waits until it is shown. It takes the place of the file that the browser
 * showed before, unless one of the two has options.
 */
export async function open(
  browser: Browser,
  file: string,
  hash = "",
  options?: BrowserContextOptions,
): Promise<Opened> {
  const page = await emptyPage(browser, options);
  // Drawing a million contacts in software takes long if other tests run at the same time.
  page.setDefaultTimeout(120000);
  const faults: string[] = [];
  page.on("console", (message) => {
    // The software renderer reports its own slowness when a page's pixels are read.
    if (["error", "warning"].includes(message.type()) && !message.text().includes("GPU stall"))
      faults.push(message.text());
  });
  page.on("pageerror", (error) => faults.push(error.message));
  page.on("request", (request) => {
    const [address] = request.url().split("#");
    if (address !== `file://${file}` && !address.startsWith("data:")) faults.push(address);
  });
  await page.goto(`file://${file}${hash}`);
  await page.waitForFunction(() => window.tamis ?? document.getElementById("unreadable"));
  await settled(page);
  return { page, faults };
}

/** Waits until the drawing no longer changes. */
export async function settled(page: Page): Promise<void> {
  await page.evaluate(
    () =>
      new Promise<void>((done) => {
        let last = -1;
        const look = (): void => {
          const frames = window.tamis?.stage?.cost.frames ?? 0;
          if (frames === last && !window.tamis?.stage?.isBusy) done();
          else setTimeout(look, 60);
          last = frames;
        };
        look();
      }),
  );
}

/** Saves a picture of the page, if TAMIS_SCREENSHOTS names a folder. */
export async function picture(page: Page, name: string): Promise<void> {
  if (!pictures) return;
  mkdirSync(pictures, { recursive: true });
  await page.screenshot({ path: join(pictures, `${name}.png`) });
}

/** How long a key takes until the page has drawn twice, in milliseconds: the best of three, as other programs run, too. */
export async function answerTo(page: Page, key: string): Promise<number> {
  const times: number[] = [];
  for (let i = 0; i < 3; ++i) {
    const pressed = performance.now();
    await page.keyboard.press(key);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    times.push(performance.now() - pressed);
    await page.waitForTimeout(250);
  }
  return Math.min(...times);
}
