// What was found, as a sentence.
import { counted, grouped } from "../numbers";
import type { Facts } from "./messages";

const milliseconds = (seconds: number): string => {
  const ms = 1000 * seconds;
  return ms < 10 ? `${ms.toFixed(1)} ms` : `${grouped(ms)} ms`;
};

export function wordsOf({ triangles, contacts, seconds, first, notes }: Facts, all: boolean): string {
  const cost = `${milliseconds(seconds)} for ${counted(triangles, "triangle")} in this browser`;
  const found =
    contacts === 0
      ? "No contact: the whole step is proven free."
      : all
        ? `${counted(contacts, "contact")}, the first at ${first.toFixed(4)} of the step. All other pairs are proven free.`
        : `The first contact is at ${first.toFixed(4)} of the step. The motion before it is proven free.`;
  return [`${found} ${cost}.`, ...notes.map((note) => `Note: ${note}.`)].join(" ");
}
