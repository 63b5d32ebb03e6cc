//! Primes below 2000 by trial division, slowly, in a folder of results that may be filled by several processes at a time.

#![allow(clippy::print_stdout, reason = "an example")]

use std::error::Error;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use soilctl_jobs::{Job, JobsError, Shard, Store, each};

fn main() -> Result<(), Box<dyn Error>> {
    let mut words = std::env::args().skip(1);
    let store = Store::open(words.next().ok_or("usage: primes FOLDER [I/N]")?);
    let shard: Option<Shard> = words.next().map(|text| text.parse()).transpose()?;
    let all = (2..2000_u32).enumerate();
    let mine = all.filter(|(place, _)| shard.is_none_or(|shard| shard.has(*place))).map(|(_, number)| number);
    let cells: Vec<String> = mine.map(|number| format!("{{\"number\":{number}}}")).collect();
    let job = |cell| Job { function: "is prime", version: "1", cell };
    let mut todo = Vec::new();
    for cell in &cells {
        if store.known(&job(cell).key())?.is_none() {
            todo.push(cell.as_str());
        }
    }
    println!("{} of {} are done", cells.len() - todo.len(), cells.len());
    let work = |cell: &&str| {
        std::thread::sleep(Duration::from_millis(10));
        let number: u32 = cell.trim_matches(|c: char| !c.is_ascii_digit()).parse().unwrap_or(0);
        Ok::<_, JobsError>(Some((2..number).all(|divisor| !number.is_multiple_of(divisor))))
    };
    each(&todo, 4, &AtomicBool::new(false), work, |cell, prime| store.put(&job(cell), &prime.to_string()))?;
    println!("the others were made");
    Ok(())
}
