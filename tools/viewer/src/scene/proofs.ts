// Every sentence of the page that says what is proven, each made from the verdicts that the scene holds.
import { counted, roundedDown } from "../numbers";
import type { Contacts } from "./contacts";
import { isPose, type SceneHeader, type StepHeader } from "./header";

/** Whether the edge and the face of a pair pass through each other: a fact of one frame, without a time or a gap. */
export const isIntersection = (contacts: Contacts, pair: number): boolean => contacts.kindOf(pair).name === "ef";

/** Whether pairs that touch at the start were ignored, so that they need not be apart before their contacts. */
const ignoresStart = ({ at_start: atStart }: SceneHeader): boolean => atStart === "ignore";

/** What is said of a step's free time where pairs were ignored. */
function butFor(header: SceneHeader, { ignored }: StepHeader): string {
  if (!ignoresStart(header)) return "";
  const which = ignored > 0 ? `${counted(ignored, "pair")} among them that never touch again` : "";
  return `, but for pairs that touch at the start and are ignored${which && `, ${which}`}`;
}

/** What the pairs of a frame are. */
export const kIntersections = ": edges that pass through triangles, or touch them; decided exactly.";

/** Of the strip of a sequence, which draws `toi_lower` of each step. */
export const kStepsTitle = "Contacts of each step; below, how much of it is free";

/** The sentence for a step without contacts. If not all contacts are listed here, the step need not be free. */
export function withoutContacts({ toi_lower: lower, ignored }: StepHeader): string {
  if (lower !== null)
    return `none in this selection; pairs outside of it may touch${lower > 0 ? ` from ${roundedDown(lower, 6)} on` : ""}.`;
  return ignored > 0
    ? `proven, but ${counted(ignored, "pair")} that touch at the start were ignored.`
    : "the step is free, proven.";
}

/** Whether a step that ends at an audit's frame was asked about. */
export const hasStep = ({ ends }: StepHeader): boolean => ends === undefined || ends[0] !== ends[1];

/** The sentence on objects that were left out; empty if none were. */
export const leftOut = ({ collapsed }: StepHeader): string =>
  collapsed === undefined ? "" : `${collapsed}. No pair of it is listed, and nothing is known of it.`;

/** The sentence for a step or frame without pairs. */
export function nothingFound(header: SceneHeader, step: StepHeader): string {
  if (step.collapsed !== undefined) return leftOut(step);
  if (!header.strip)
    return isPose(header)
      ? "no edge passes through or touches a triangle that shares no vertex with it, proven."
      : withoutContacts(step);
  if (header.strip.asks_intersections)
    return hasStep(step)
      ? "nothing was found in this frame, nor in the step to it."
      : "nothing was found in this frame; no step to it was asked about.";
  return hasStep(step)
    ? "nothing was found in the step to this frame, whose intersections were not asked about."
    : "neither this frame's intersections nor a step to it were asked about.";
}

/** Why no pair ends the step. */
export function nothingStops(header: SceneHeader, step: StepHeader): string {
  if (!header.strip) return nothingFound(header, step);
  return hasStep(step) ? "it has no contact." : "no step to this frame was asked about.";
}

/** The words before the time until which a step is free, the time, and the words after it. */
export function freeBefore(header: SceneHeader, step: StepHeader): [string, string, string] {
  return ["Free before ", roundedDown(step.toi_lower ?? 1, 6), ` of the step, proven${butFor(header, step)}.`];
}

/** What the pair that ends a step is told to do, at `time`, before which it does not touch. */
export function whatEnds(header: SceneHeader, step: StepHeader, time: number): string {
  const free = step.toi_lower ?? 1;
  return free === time
    ? `Free before ${time}, proven${butFor(header, step)}. This pair ends it.`
    : `Free before ${free}, proven${butFor(header, step)}. Of what is listed here this pair is the first, at ${time}.`;
}

/** What is known of one pair. */
export function verdictOf(header: SceneHeader, contacts: Contacts, pair: number): string {
  if (isIntersection(contacts, pair)) return "They share a point, though no vertex: decided exactly.";
  const before = ignoresStart(header)
    ? "Before, it does not touch, unless it touches from the start, which was ignored."
    : "It does not touch before, proven.";
  return contacts.isUnresolved(pair)
    ? `Unresolved: doubles cannot decide whether it touches, so it is reported. ${before}`
    : `Certified: it touches within the bracket. ${before}`;
}

/** The words in a contact's bracket: before it, within it, after it. */
export function bracketWords(header: SceneHeader, contacts: Contacts, pair: number): [string, string, string] {
  const starts = contacts.toiLower[pair] === 0;
  const before = starts ? "" : ignoresStart(header) ? "free, or ignored" : "free, proven";
  return [before, contacts.isUnresolved(pair) ? "may touch in here" : "touches in here", "after"];
}

/** Whether the counts of stages were kept for a step: only then there is a sieve. */
export const hasSieve = ({ stages }: StepHeader): boolean => stages.length > 0;

/** `part` of `all` > 0 as percent, with all leading nines and one digit more; 100 % only if nothing is left. */
export function percentWithout(left: number, all: number): string {
  if (left === 0) return "100 %";
  const digits = Math.min(Math.max(1, Math.ceil(-Math.log10(left / all)) - 1), 20);
  // The complement of the rest, rounded up: 1 - rest would round to 1.
  const unit = 10n ** BigInt(digits);
  const rest = BigInt(Math.ceil(Math.min((100 * left * 10 ** digits) / all, 100 * 10 ** digits)));
  const kept = 100n * unit - (rest > 0n ? rest : 1n);
  return `${kept / unit}.${String(kept % unit).padStart(digits, "0")} %`;
}

/** How much of all pairs does not touch. Pairs that no question was asked about are among them. */
export function shareOf(step: StepHeader, all: number, left: number): string {
  if (step.collapsed !== undefined) return leftOut(step);
  if (!step.complete) return "Only a part of the contacts that were found is in this page. Areas are true to scale.";
  if (left === 0 && step.toi_lower !== null) return withoutContacts(step);
  const ignored = step.ignored > 0 ? `, or touch at the start and are ignored (${step.ignored})` : "";
  return `${percentWithout(left, Math.max(all, 1))} of all pairs are proven free, or not asked about: neighbours, and what was left out${ignored}. Areas are true to scale.`;
}
