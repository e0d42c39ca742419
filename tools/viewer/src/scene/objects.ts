// The objects of the mesh and what they are called.

export class Objects {
  /** The numbers of objects that have vertices, in ascending order. */
  readonly numbers: number[];

  /** `ofVertex`: -1 for none. `names`: by number; there may be none, or fewer than objects. */
  constructor(
    ofVertex: Int32Array,
    private readonly names: string[],
  ) {
    this.numbers = [...new Set(ofVertex)].filter((object) => object >= 0).sort((a, b) => a - b);
  }

  get areNamed(): boolean {
    return this.names.length > 0;
  }

  nameOf(object: number): string {
    return this.names[object] ?? (object < 0 ? "none" : String(object));
  }

  /** Returns a test for the objects that a filter names: by a part of the name, or by the number. */
  chosen(text: string): (object: number) => boolean {
    const wanted = text.trim().toLowerCase();
    const isNamed = (object: number): boolean => this.names[object]?.toLowerCase().includes(wanted) ?? false;
    const chosen = new Set(this.numbers.filter((object) => String(object) === wanted || isNamed(object)));
    return (object) => chosen.has(object);
  }
}
