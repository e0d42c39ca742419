//! For each method of simulating: how many throws it lets through, how many are not proven free, and the cost of a
//! step:
//! `cargo run --release --example throws [THROWS]`.
mod judge;
mod scenes;

use scenes::{spinning_plates, spinning_rods, Throw, METHODS};
use tamis_rapier::Error;

const SAMPLES: usize = 16;

fn report(title: &str, throws: &[Throw]) -> Result<(), Error> {
    println!(
        "{title}: {} throws\n{:24} {:>9} {:>12} {:>9} {:>10}",
        throws.len(),
        "",
        "through",
        "not proven",
        "sampled",
        "ms a step"
    );
    for method in METHODS {
        let (mut through, mut unproven, mut crossing, mut steps, mut milliseconds) = (0, 0, 0, 0, 0.0);
        for thrown in throws {
            let flight = thrown.fly(&method)?;
            through += usize::from(thrown.is_through(&flight));
            unproven += usize::from(!thrown.is_proven(&flight)?);
            crossing += usize::from(thrown.is_seen_crossing(&flight, SAMPLES));
            steps += thrown.steps();
            milliseconds += 1e3 * flight.time.as_secs_f64();
        }
        let each = milliseconds / steps as f64;
        println!("{:24} {through:>9} {unproven:>12} {crossing:>9} {each:>10.3}", method.name);
    }
    Ok(())
}

fn main() -> Result<(), Error> {
    let count = std::env::args().nth(1).map_or(40, |count| count.parse().expect("THROWS is a number"));
    report("Spinning plates", &spinning_plates(count))?;
    report("Spinning rods", &spinning_rods(count))
}
