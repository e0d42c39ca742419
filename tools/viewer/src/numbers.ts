// Numbers as text for readers.

export const grouped = (n: number): string => Math.round(n).toLocaleString("en-US");

/** "1 contact", "1,588 contacts". */
export const counted = (n: number, name: string): string => `${grouped(n)} ${name}${n === 1 ? "" : "s"}`;

/** A text of at most `most` characters: of a longer one the beginning and the end. */
export function shortened(text: string, most: number): string {
  if (text.length <= most) return text;
  const end = Math.floor((most - 1) / 2);
  return `${text.slice(0, most - 1 - end)}…${text.slice(text.length - end)}`;
}

/** 1.4e10 as "14 billion". */
export function inWords(n: number): string {
  for (const [size, name] of [
    [1e12, "trillion"],
    [1e9, "billion"],
    [1e6, "million"],
  ] as const)
    if (n >= size) return `${(n / size).toPrecision(3)} ${name}`;
  return grouped(n);
}

const kSuperscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** 3.2e-14 as 3.2 × 10⁻¹⁴. */
export function scientific(x: number): string {
  if (x === 0) return "0";
  const [digits, power] = x.toExponential(1).split("e");
  const raised = Array.from(power.replace("+", ""))
    .map((c) => (c === "-" ? "⁻" : kSuperscripts[Number(c)]))
    .join("");
  return `${digits} × 10${raised}`;
}

/** `x` >= 0 with `digits` digits, rounded down: a step that is proven free before `x` is free before this number. */
export function roundedDown(x: number, digits: number): string {
  const text = x.toPrecision(digits);
  if (Number(text) <= x) return text;
  const [mantissa, power] = x.toExponential(digits - 1).split("e");
  // One less in the last digit. 1.00000 becomes .999999, with one digit more behind the point.
  const unit = Number(power) - (digits - 1);
  const less = Number(mantissa.replace(".", "")) - 1;
  const below = less < 10 ** (digits - 1) ? `${10 * less + 9}e${unit - 1}` : `${less}e${unit}`;
  return Number(below).toPrecision(digits);
}

export const timeText = (t: number): string => t.toFixed(4);
