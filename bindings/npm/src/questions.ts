import type { Contact, Earliest, Intersection, Layout, NearPair, Rows, SafeStep } from "./answers.js";
import { Handle } from "./handle.js";
import type { Numbered } from "./handle.js";
import { safeStep } from "./layouts.js";
import { within } from "./memory.js";
import type { Module } from "./module.js";

/** The cost of a question. */
export interface Statistics {
  seconds: number;
  /** The hierarchy was built, not refitted. */
  rebuilt: boolean;
  decidedByLanes: number;
  decidedByScalar: number;
  decidedByExact: number;
  /** On paths only. */
  unresolved: number;
  /** Nodes of the trees. */
  nodesVisited: number;
  /** That the detector or the world holds. */
  memoryBytes: number;
  /** With atStart "ignore": pairs that touch at the start, and not again. */
  ignored: number;
  /** The pipeline's stages in order, and how many pairs of each kind entered each. */
  stages: { name: string; pairs: number[] }[];
}

const SIZE = { safeStep: 112, statistics: 1280, stage: 72 };

/** What detectors and worlds have in common: a question, then rows that are copied. */
export abstract class Questions<C extends Contact, N extends NearPair, I extends Intersection> extends Handle {
  /** @internal */
  protected constructor(
    module: Module,
    kind: "detector" | "world",
    private readonly layouts: { contact: Layout<C>; near: Layout<N>; intersection: Layout<I> },
  ) {
    super(module, kind);
  }

  /** The cost of the last question. */
  statistics(): Statistics {
    return within(this.module, (given) => {
      const place = given.struct(SIZE.statistics, []);
      this.call(`${this.kind}_statistics`, place);
      const counts = (at: number, length: number) => Array.from(new BigUint64Array(this.module.HEAPU8.buffer, place + at, length), Number);
      const [decidedByLanes, decidedByScalar, decidedByExact, unresolved, nodesVisited, memoryBytes] = counts(64, 6);
      const stages = Array.from({ length: this.module.HEAP32[(place + 112) / 4] }, (_, i) => ({
        name: this.module.UTF8ToString(this.module.HEAPU32[(place + 120 + SIZE.stage * i) / 4]), pairs: counts(128 + SIZE.stage * i, 4),
      }));
      return {
        seconds: given.viewOfDoubles(place + 16, 1)[0], rebuilt: given.viewOfIntegers(place + 12, 1)[0] !== 0, decidedByLanes, decidedByScalar,
        decidedByExact, unresolved, nodesVisited, memoryBytes, ignored: counts(1272, 1)[0], stages,
      };
    });
  }

  /** @internal */
  protected contactRows(question: string, numbers: Numbered): Rows<C> {
    return this.counted(this.layouts.contact, "contacts", question, numbers);
  }
  /** @internal */
  protected nearRows(numbers: Numbered): Rows<N> {
    return this.counted(this.layouts.near, "pairs_within", "pairs_within", numbers);
  }
  /** @internal */
  protected intersectionRows(numbers: Numbered): Rows<I> {
    return this.counted(this.layouts.intersection, "intersections", "intersections", numbers);
  }

  /** @internal */
  protected first(question: string, numbers: Numbered): Earliest<C> {
    return this.ask((given) => {
      const asked = numbers(given);
      const [times, count] = [given.room(16), given.room(4)];
      this.call(`${this.kind}_${question}`, ...asked, times, times + 8, count);
      const [toiLower, toiUpper] = given.viewOfDoubles(times, 2);
      const contacts = this.copied(this.layouts.contact, "contacts", count);
      return { toiLower, toiUpper, contact: contacts.length > 0 ? contacts.at(0) : null };
    });
  }

  /** @internal */
  protected flag(question: string, numbers: Numbered): boolean {
    return this.ask((given) => {
      const asked = numbers(given), flag = given.room(4);
      this.call(`${this.kind}_${question}`, ...asked, flag);
      return given.viewOfIntegers(flag, 1)[0] !== 0;
    });
  }

  /** @internal */
  protected safeStepBy(numbers: Numbered): SafeStep<N> {
    return this.ask((given) => {
      const asked = numbers(given), place = this.rows.struct(SIZE.safeStep, []);
      this.call(`${this.kind}_safe_step`, ...asked, place);
      return safeStep(this.layouts.near).read(this.rows, place);
    });
  }

  private counted<Row>(layout: Layout<Row>, copied: string, question: string, numbers: Numbered): Rows<Row> {
    return this.ask((given) => {
      const asked = numbers(given), count = given.room(4);
      this.call(`${this.kind}_${question}`, ...asked, count);
      return this.copied(layout, copied, count);
    });
  }

  /** The rows of the question just asked, whose number was written. */
  private copied<Row>(layout: Layout<Row>, name: string, count: number): Rows<Row> {
    const length = this.module.HEAPU32[count / 4];
    return this.table(layout, length, (place, bytes) => this.call(`${this.kind}_copy_${name}`, 0, length, place, bytes));
  }
}
