import { advantage, type Better } from "./metrics.ts";

export interface Point {
  cost: number;
  error: number;
}

/**
 * Positions of the points that no other is at once as cheap and as good as, and cheaper or better; by ascending cost.
 * Equal points are on the front together. `better` is the direction of the error; a lower cost is always better.
 */
export function paretoFront(points: readonly Point[], better: Better): number[] {
  const order = points
    .map((_, at) => at)
    .sort((a, b) => {
      const x = points[a]!;
      const y = points[b]!;
      return x.cost - y.cost || advantage(better, y.error, x.error) || a - b;
    });
  const front: number[] = [];
  for (const at of order) {
    const point = points[at]!;
    const last = front.length > 0 ? points[front[front.length - 1]!]! : null;
    const gain = last === null ? 1 : advantage(better, point.error, last.error);
    if (gain > 0 || (gain === 0 && point.cost === last!.cost)) front.push(at);
  }
  return front;
}
