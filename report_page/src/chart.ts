import { BoxplotChart, LineChart, ScatterChart } from "echarts/charts";
import {
  DataZoomInsideComponent,
  GridComponent,
  MarkLineComponent,
  TitleComponent,
  TooltipComponent,
} from "echarts/components";
import { type EChartsCoreOption, type EChartsType, init, use } from "echarts/core";
import { CanvasRenderer } from "echarts/renderers";

import { h } from "./dom.ts";
import { type FigureScale } from "./scales.ts";

use([
  BoxplotChart,
  CanvasRenderer,
  DataZoomInsideComponent,
  GridComponent,
  LineChart,
  MarkLineComponent,
  ScatterChart,
  TitleComponent,
  TooltipComponent,
]);

export type Option = EChartsCoreOption;

/** Colours and sizes of the page, for what is drawn on a canvas. */
export interface Ink {
  text: string;
  muted: string;
  line: string;
  panel: string;
  accent: string;
  font: string;
  size: number;
}

export function currentInk(): Ink {
  const style = getComputedStyle(document.documentElement);
  const colour = (name: string) => style.getPropertyValue(name).trim();
  return {
    text: colour("--ink"),
    muted: colour("--muted"),
    line: colour("--line"),
    panel: colour("--panel"),
    accent: colour("--accent"),
    font: getComputedStyle(document.body).fontFamily,
    size: Math.round(parseFloat(style.fontSize) * 0.8),
  };
}

/** A chart that is laid out for its element's size. `onClick` gets the clicked item's data. */
export class Chart {
  readonly element: HTMLElement;
  private chart: EChartsType | null = null;
  private make: ((width: number) => Option) | null = null;
  private option: Option | null = null;
  private width = 0;

  constructor(label: string, onClick: (data: unknown) => void = () => {}) {
    this.element = h("div", { class: "chart", attrs: { role: "img", "aria-label": label } });
    new ResizeObserver(() => {
      // An element that is not shown has no size yet.
      if (this.element.clientWidth === 0) return;
      const isFirst = this.chart === null;
      if (this.chart === null) this.start(onClick);
      else this.chart.resize();
      if (isFirst || this.element.clientWidth !== this.width) this.draw();
    }).observe(this.element);
  }

  private start(onClick: (data: unknown) => void): void {
    this.chart = init(this.element, null, { renderer: "canvas" });
    this.chart.on("click", (event) => onClick(event.data));
    // Back from where wheel and drag have led.
    this.chart.getZr().on("dblclick", () => this.draw());
    this.chart.on("datazoom", () => this.numberWhatIsSeen());
  }

  /** `make` is called now and whenever the width changes, with the width in pixels. */
  show(make: (width: number) => Option): void {
    this.make = make;
    this.draw();
  }

  private draw(): void {
    if (this.make === null || this.element.clientWidth === 0) return;
    this.width = this.element.clientWidth;
    this.option = { animation: false, ...this.make(this.width) };
    this.chart?.setOption(this.option, { notMerge: true });
  }

  /** Numbers of the axes anew, for what zooming left of them. */
  private numberWhatIsSeen(): void {
    const of = (name: "xAxis" | "yAxis") =>
      [this.option?.[name] ?? []].flat().map((axis, at) => {
        const { ticksOf, textOf } = axis as Partial<TickedAxis>;
        if (ticksOf === undefined || textOf === undefined) return {};
        return customTicks(ticksOf(...seenExtent(this.chart!, name, at)), textOf);
      });
    this.chart?.setOption({ xAxis: of("xAxis"), yAxis: of("yAxis") });
  }
}

/** An axis whose numbers are chosen here: ECharts' own may be one or none on a short logarithmic axis. */
interface TickedAxis {
  ticksOf(from: number, to: number): number[];
  textOf(value: number, ofAxis: readonly number[]): string;
}

function customTicks(values: number[], textOf: TickedAxis["textOf"]): Record<string, object> {
  const formatter = (value: number) => textOf(value, values);
  return { axisTick: { customValues: values }, axisLabel: { customValues: values, formatter } };
}

/** What zooming has left of an axis; nothing that is public tells. */
function seenExtent(chart: EChartsType, name: string, at: number): [number, number] {
  interface Model {
    getComponent(name: string, at: number): { axis: { scale: { getExtent(): [number, number] } } };
  }
  const model = (chart as unknown as { getModel(): Model }).getModel();
  return model.getComponent(name, at).axis.scale.getExtent();
}

/** The axis with numbers at `ticksOf` what is seen of it, `textOf` each. */
export function ticked(
  axis: Record<string, unknown> & { min: number; max: number },
  ticksOf: TickedAxis["ticksOf"],
  textOf: TickedAxis["textOf"],
): Record<string, unknown> {
  const { axisTick, axisLabel } = customTicks(ticksOf(axis.min, axis.max), textOf);
  return {
    ...axis,
    ticksOf,
    textOf,
    axisTick: { ...(axis["axisTick"] as object), ...axisTick },
    axisLabel: { ...(axis["axisLabel"] as object), ...axisLabel },
  };
}

/** What all axes look like. */
export function axisStyle(ink: Ink, name: string): Record<string, unknown> {
  return {
    name,
    nameLocation: "middle",
    nameTextStyle: { color: ink.muted, fontFamily: ink.font, fontSize: ink.size, lineHeight: 1.3 * ink.size },
    axisLabel: { color: ink.muted, fontFamily: ink.font, fontSize: ink.size, hideOverlap: true },
    axisLine: { show: true, onZero: false, lineStyle: { color: ink.line } },
    axisTick: { show: true, lineStyle: { color: ink.line } },
    splitLine: { show: true, lineStyle: { color: ink.line, opacity: 0.6 } },
    minorSplitLine: { show: false },
  };
}

/** An axis for a figure; `labelled`: with numbers at its ticks. */
export function figureAxis(ink: Ink, name: string, scale: FigureScale, labelled: boolean): Record<string, unknown> {
  const style = axisStyle(ink, name);
  const axisLabel = { ...(style["axisLabel"] as object), show: labelled };
  const axis = { ...style, axisLabel, type: scale.type, min: scale.min, max: scale.max };
  return ticked(axis, scale.ticks, scale.text);
}

/** Zooming into the grid with these axes. A finger that is drawn over the chart scrolls the page. */
export function insideZoom(grid: number): object[] {
  const drags = !matchMedia("(pointer: coarse)").matches;
  const one = { type: "inside", filterMode: "none", moveOnMouseMove: drags, preventDefaultMouseMove: drags };
  return ["xAxisIndex", "yAxisIndex"].map((axis) => ({ ...one, [axis]: grid }));
}

/** Bars from end to end: `data` has the two ends of each and a gap after them. */
export function intervalLine(data: (number | null)[][], colour: string, more: object = {}): object {
  return {
    type: "line",
    data,
    symbol: "none",
    silent: true,
    connectNulls: false,
    lineStyle: { color: colour, width: 1.1, opacity: 0.6 },
    z: 2,
    ...more,
  };
}

export function tooltipStyle(ink: Ink): Record<string, unknown> {
  return {
    trigger: "item",
    confine: true,
    backgroundColor: ink.panel,
    borderColor: ink.line,
    padding: [8, 12],
    textStyle: { color: ink.text, fontFamily: ink.font, fontSize: ink.size },
    extraCssText: "box-shadow: 0 4px 16px rgb(0 0 0 / 18%); border-radius: 6px; max-width: 30rem;",
    transitionDuration: 0,
  };
}
