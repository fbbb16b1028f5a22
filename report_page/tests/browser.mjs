// A Chromium for tests and benchmarks, with nothing of its own on the network.

import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { chromium } from "playwright-core";

const executables = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

/** A browser with a profile of its own; `close` deletes that. */
export async function openBrowser() {
  const executablePath = executables.find((path) => path && existsSync(path));
  if (!executablePath) throw new Error("there is no Chromium: run scripts/install_packages, or set CHROMIUM to one");
  const profile = mkdtempSync(join(tmpdir(), "reliefbench-chromium-"));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath,
    headless: true,
    viewport: { width: 1280, height: 900 },
    args: [
      "--no-sandbox",
      "--disable-gpu",
      "--disable-quic",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
    ],
  });
  return {
    context,
    async close() {
      await context.close();
      rmSync(profile, { recursive: true, force: true });
    },
  };
}
