// Numbers as text for readers.
import assert from "node:assert/strict";
import { test } from "node:test";
import { roundedDown } from "../src/numbers";

// Bug: the page says "free before 0.253160, proven" of a pair that touches at 0.25315997.
void test("a time that is proven free before is never rounded up", () => {
  assert.equal(roundedDown(0.25315997144385066, 6), "0.253159");
  assert.equal(roundedDown(7.4920691723933284e-6, 6), "0.00000749206");
  assert.equal(roundedDown(0.25, 6), "0.250000");
  assert.equal(roundedDown(0.3, 6), "0.300000");
  assert.equal(roundedDown(0, 6), "0.00000");
  assert.equal(roundedDown(1, 6), "1.00000");
});

// Bug: just below a power of ten a digit is lost, or the number is ten times too small.
void test("a carry is taken back", () => {
  assert.equal(roundedDown(1 - 2 ** -53, 6), "0.999999");
  assert.equal(roundedDown(0.00099999999, 3), "0.000999");
  assert.equal(roundedDown(9.99e-10, 1), "9e-10");
  assert.equal(roundedDown(9.96, 1), "9");
});

void test("what is rounded down is the nearest below", () => {
  let seed = 1;
  const random = (): number => (seed = (seed * 48271) % 2147483647) / 2147483647;
  for (let i = 0; i < 20000; ++i) {
    const x = i % 2 === 0 ? random() : random() * 10 ** (-320 * random());
    const digits = 1 + (i % 15);
    const text = roundedDown(x, digits);
    const back = Number(text);
    assert.ok(back <= x, `${text} > ${x}`);
    // Subnormal doubles have fewer digits than are asked for.
    if (x > 1e-290) assert.ok(x - back <= 1.0001 * x * 10 ** (1 - digits), `${text} is far below ${x}`);
  }
});
