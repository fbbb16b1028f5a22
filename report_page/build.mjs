// Bundles the page into one HTML file: node build.mjs OUTPUT [TESTS_FOLDER]
// With a folder of tests named, bundles those too, one .mjs each, for node's own test runner.

import { createHash } from "node:crypto";
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { build } from "esbuild";

// Where this file is found, which may be by a link beside node_modules: not where it really lies.
const here = dirname(process.argv[1]) || dirname(fileURLToPath(import.meta.url));
const [output, tests] = process.argv.slice(2);
const source = (name) => readFileSync(join(here, "src", name), "utf8");
const shared = { absWorkingDir: here, bundle: true, preserveSymlinks: true, write: false, logLevel: "warning" };

const script = await build({
  ...shared,
  entryPoints: ["src/main.ts"],
  minify: true,
  format: "iife",
  target: ["chrome100", "firefox115", "safari16"],
  legalComments: "inline",
  charset: "utf8",
});
const style = await build({ ...shared, entryPoints: ["src/page.css"], minify: true });
// The script stands in an HTML element, which no text of it may end.
const code = script.outputFiles[0].text.trim().replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
const hash = createHash("sha256").update(code).digest("base64");

const page = source("page.html")
  .replace("SCRIPT_HASH", () => `sha256-${hash}`)
  .replace("PAGE_STYLE", () => style.outputFiles[0].text.trim())
  .replace("PAGE_SCRIPT", () => code);
writeFileSync(output, page);

if (tests) {
  mkdirSync(tests, { recursive: true });
  const entryPoints = readdirSync(join(here, "tests")).filter((name) => name.endsWith(".test.ts"));
  await build({
    ...shared,
    write: true,
    entryPoints: entryPoints.map((name) => join("tests", name)),
    outdir: tests,
    platform: "node",
    format: "esm",
    outExtension: { ".js": ".mjs" },
    target: "node18",
  });
}
