#!/usr/bin/env python3
"""Tests scripts/check_assertions.py: it finds a planted test without an expectation in each language, and no other."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from check_assertions import tests_that_expect_nothing

SOURCES = {
    "a_test.cpp": """
void expect_free(int x) { if (x) { EXPECT_EQ(x, 1) << "}"; } }
void twice(int x) { expect_free(x); expect_free(x); }
TEST(A, Expects) { EXPECT_TRUE(true); }
TEST_F(A, AsksAHelper) { for (int i : {1, 2}) twice(i); }
TEST(A, AsksALambda) { const auto refuses = [&](int x) { EXPECT_THROW(f(x), E); }; refuses(1); }
TEST_P(A, RunsOnly) { run(1); }  // EXPECT_TRUE(true)
TEST(A, NamesOneInAString) { print("EXPECT_TRUE(true)"); }
""",
    "test_a.py": '''
def helper(x):
    assert x


def test_expects():
    helper(1)


def test_runs_only():
    """It does not assert anything."""
    run(1)  # assert


class TestIt:
    def test_raises(self):
        with pytest.raises(ValueError):
            run(2)
''',
    "a.test.mjs": """
test('expects', () => { assert.equal(1, 1); });
test('runs only', async () => { await run(); });
""",
    "a.rs": """
fn helper(x: i32) { assert_eq!(x, 1); }
#[test]
fn expects() { helper(1); }
#[test]
fn runs_only() { run(1); }
""",
}
EXPECTED = ["a_test.cpp:7: TEST_P(A, RunsOnly", "a_test.cpp:8: TEST(A, NamesOneInAString", "test_a.py:10: test_runs_only",
            "a.test.mjs:3: test('runs only'", "a.rs:5: #[test] fn runs_only"]

found = tests_that_expect_nothing(SOURCES)
if found != EXPECTED:
    sys.exit(f"found\n  {found}\nplanted were\n  {EXPECTED}")
print("found what was planted, and nothing else")
