// Colours that colour-blind people can tell apart: a scale for time, with rising lightness, and a few for objects.

/** Eleven steps of Plasma (Smith, van der Walt; CC0): late is dark, early is bright. */
const kPlasma = [
  [0x5c, 0x01, 0xa6],
  [0x7e, 0x03, 0xa8],
  [0x9c, 0x17, 0x9e],
  [0xb5, 0x2f, 0x8c],
  [0xcc, 0x47, 0x78],
  [0xde, 0x5f, 0x65],
  [0xed, 0x79, 0x53],
  [0xf8, 0x95, 0x40],
  [0xfd, 0xb4, 0x2f],
  [0xfb, 0xd5, 0x24],
  [0xf0, 0xf9, 0x21],
];

export type Rgb = [number, number, number];

/** The colour of a time of impact, components 0 to 255. */
export function colourOfTime(time: number): Rgb {
  const place = (1 - Math.min(Math.max(time, 0), 1)) * (kPlasma.length - 1);
  const below = Math.min(Math.floor(place), kPlasma.length - 2);
  const part = place - below;
  return kPlasma[below].map((c, i) => Math.round(c + part * (kPlasma[below + 1][i] - c))) as Rgb;
}

export function css(colour: Rgb): string {
  return `rgb(${colour.join(" ")})`;
}

/** Colours of objects in turn: muted, so that contacts stand out. */
export const kObjectColours: Rgb[] = [
  [0x8b, 0xa3, 0xc4],
  [0xc9, 0xbd, 0xa4],
  [0x8f, 0xb5, 0xac],
  [0xb9, 0xa6, 0xc2],
  [0xb8, 0xc0, 0xc8],
  [0xa9, 0xb1, 0x8c],
];

/** The first and the second feature of a pair (Okabe and Ito's orange and sky blue). */
export const kFirstFeature: Rgb = [0xf5, 0x9e, 0x0b];
export const kSecondFeature: Rgb = [0x38, 0xb2, 0xf0];
