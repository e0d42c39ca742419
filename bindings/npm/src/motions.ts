import { need, only, rowsOf } from "./memory.js";
import type { Memory, Numbers } from "./memory.js";

/** How bodies move, one body after the other. Give one of the three; nothing: each stays where its shape's points are. */
export interface Motions {
  /** A pose for each body, which stays there. */
  poses?: Numbers;
  /** A chain for each body, all of as many links: it moves as a whole. */
  links?: Numbers;
  /** Each vertex goes straight, in the world's frame: where it is at t=0 ... */
  start?: Numbers;
  /** ... and at t=1. */
  end?: Numbers;
}

const SIZE = 32;

export function motionsOf(given: Memory, count: number, motions: Motions): number {
  only(motions, "motions", "poses", "links", "start", "end");
  const { poses, links, start, end } = motions;
  need(!poses || poses.length === 6 * count, `poses has ${poses?.length} numbers: give 6 for each of ${count} bodies`, 9);
  need(!start || !end || start.length === end.length, `start has ${start?.length} numbers, end ${end?.length}: give as many`, 3);
  const each = (numbers: Numbers | undefined, width: number, name: string, row: string) => rowsOf(numbers ?? [], width * count, name, row) || 0;
  const linksOfEach = each(links, 12, "links", `link of all ${count} bodies`);
  const vertexCount = each(start ?? end, 3, "start", `vertex of all ${count} bodies`);
  const place = (numbers: Numbers | undefined) => (numbers ? given.doubles(numbers) : 0);
  return given.struct(SIZE, [count, place(poses), place(links), linksOfEach, place(start), place(end), vertexCount]);
}
