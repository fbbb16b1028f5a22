export interface Point {
  cost: number;
  error: number;
}

/**
 * Positions of the points that no other is at once as cheap and as good as, and cheaper or better; by ascending cost.
 * Equal points are on the front together.
 */
export function paretoFront(points: readonly Point[]): number[] {
  const order = points
    .map((_, at) => at)
    .sort((a, b) => {
      const x = points[a]!;
      const y = points[b]!;
      return x.cost - y.cost || x.error - y.error || a - b;
    });
  const front: number[] = [];
  for (const at of order) {
    const point = points[at]!;
    const last = front.length > 0 ? points[front[front.length - 1]!]! : null;
    if (last === null || point.error < last.error || (point.error === last.error && point.cost === last.cost)) {
      front.push(at);
    }
  }
  return front;
}
