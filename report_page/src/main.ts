import { type PackedPageData, unpackPage } from "./data.ts";
import { startShell } from "./shell.ts";

const text = document.getElementById("data")?.textContent ?? "null";
const data = JSON.parse(text) as PackedPageData | string | null;

if (data === null || typeof data === "string") {
  document.body.textContent = "This page holds no run: `reliefbench report RUN -o report.html` fills it.";
} else {
  startShell(unpackPage(data), document.body);
}
