import { Rows } from "./answers.js";
import type { Layout } from "./answers.js";
import { Memory, need, rethrow, TamisError, within } from "./memory.js";
import type { Module } from "./module.js";

/** The numbers that a function of C takes; `given` holds what they point to. */
export type Numbered = (given: Memory) => number[];

/** Something that C has made: a detector, a world, ... Free it when it is no longer needed: `using`, or `free()`. */
export abstract class Handle {
  /** @internal Memory until it is freed. */
  protected readonly kept: Memory;
  /** @internal Memory of the last answer. */
  protected rows: Memory;
  private handle = 0;
  /** How many questions it takes part in now: then it cannot be freed. */
  private questions = 0;
  private lent: Handle[] = [];

  /** @internal */
  protected constructor(
    /** @internal */
    readonly module: Module,
    /** @internal Of its functions: "world". */
    protected readonly kind: string,
  ) {
    this.kept = new Memory(module);
    this.rows = new Memory(module);
  }

  /** Frees its memory and its answers. Freeing twice does nothing. */
  free(): void {
    this.needRest();
    if (this.handle !== 0) this.module[`_tamis_${this.kind}_free`](this.handle);
    this.handle = 0;
    this.rows.free();
    this.kept.free();
  }

  /** @internal The pointer, for another handle's question. */
  placeFor(module: Module): number {
    need(this.handle !== 0, `this ${this.kind} has been freed: make a new one`);
    need(module === this.module, `this ${this.kind} is of another load(): use things of one load() together`);
    return this.handle;
  }

  /** @internal Makes the handle: `create` of C takes these numbers, then where to write it. */
  protected make(create: string, numbers: Numbered): void {
    try {
      within(this.module, (given) => {
        const at = given.room(4);
        const status = this.module[`_tamis_${create}`](...numbers(given), at);
        this.handle = this.module.HEAPU32[at / 4];
        this.check(status);
      });
    } catch (error) {
      this.free();
      throw error;
    }
  }

  /** @internal Calls a function of C with this handle first. */
  protected call(name: string, ...numbers: number[]): void {
    this.check(this.module[`_tamis_${name}`](this.placeFor(this.module), ...numbers));
  }

  /** @internal Asks a question, whose answer lies in `rows`. The one before ends afterwards: it may be an argument. */
  protected ask<Answer>(question: (given: Memory) => Answer): Answer {
    this.needRest();
    this.placeFor(this.module);
    const before = this.rows;
    this.rows = new Memory(this.module);
    ++this.questions;
    try {
      return within(this.module, question);
    } finally {
      --this.questions;
      for (const other of this.lent.splice(0)) --other.questions;
      before.free();
    }
  }

  /** @internal Another handle that takes part in the question being asked. */
  protected lend(other: Handle): number {
    const place = other.placeFor(this.module);
    ++other.questions;
    this.lent.push(other);
    return place;
  }

  /** @internal An answer of so many rows, which `call` of C takes with its size. */
  protected table<Row>(layout: Layout<Row>, length: number, call: (place: number, bytes: number) => void): Rows<Row> {
    const { rows } = this;
    const place = rows.room(layout.bytes * length);
    call(place, layout.bytes);
    return new Rows(length, (i) => {
      need(!rows.isFree, "a later question has ended this answer: copy what you keep");
      return layout.read(rows, place + layout.bytes * i);
    });
  }

  private check(status: number): void {
    rethrow();
    if (status === 0) return;
    const message = this.module[`_tamis_${this.kind}_message`](this.handle);
    throw new TamisError((message !== 0 && this.module.UTF8ToString(message)) || "out of memory: free detectors, or take a smaller mesh", status);
  }

  private needRest(): void {
    need(this.questions === 0, `this ${this.kind} is still answering: wait until its question has returned`, 6);
  }
}

/** `using` frees it, where the engine knows it. */
if (typeof Symbol.dispose === "symbol") Object.defineProperty(Handle.prototype, Symbol.dispose, { value: Handle.prototype.free });
export interface Handle extends Disposable {}
