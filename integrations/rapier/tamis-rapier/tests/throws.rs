//! A few of the throws of `examples/throws`: rapier alone lets some through; the clamp lets none through, and that is
//! proven.
#[path = "../examples/throws/judge.rs"]
mod judge;
// The example uses more than this test does.
#[allow(dead_code)]
#[path = "../examples/throws/scenes.rs"]
mod scenes;

use scenes::{spinning_plates, spinning_rods, Throw, METHODS};

fn nothing_passes_when_clamped(throws: &[Throw]) {
    for method in METHODS {
        let mut through = 0;
        for (number, thrown) in throws.iter().enumerate() {
            let flight = thrown.fly(&method).unwrap();
            through += usize::from(thrown.is_through(&flight));
            if method.is_clamped {
                assert!(thrown.is_proven(&flight).unwrap(), "{}, throw {number}", method.name);
                assert!(!thrown.is_seen_crossing(&flight, 16), "{}, throw {number}", method.name);
            }
        }
        assert!(!method.is_clamped || through == 0, "{}: {through} are through", method.name);
        assert!(method.is_clamped || method.is_hull || through > 0, "{}: none is through", method.name);
    }
}

#[test]
fn plates() {
    nothing_passes_when_clamped(&spinning_plates(6));
}

#[test]
fn rods() {
    nothing_passes_when_clamped(&spinning_rods(4));
}
