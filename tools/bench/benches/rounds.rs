//! Every rasterizer on every figure in interleaved rounds: `cargo bench -p zrow-bench --bench rounds -- [FOLDER]`.
//!
//! Prints a line of comma-separated values for each as soon as it is known; with a folder, the masks go there as PGM files.
//! The accuracy report reads both.

mod rasterizers;

use std::{fs, hint::black_box, io, path::Path, time::Duration};

use rasterizers::{Input, RASTERIZERS, Rasterizer};
use zrow_bench::{Spread, Work, interleaved};

const ROUNDS: usize = 101;
/// Short, so that few turns are disturbed by whatever else runs here.
const TURN: Duration = Duration::from_micros(250);

fn main() -> io::Result<()> {
    // Cargo says what it runs, too.
    let folder = std::env::args().skip(1).find(|argument| !argument.starts_with("--"));
    println!("figure,size,rasterizer,ns,ns lower quartile,ns upper quartile,rounds");
    for input in Input::all() {
        let works = RASTERIZERS.iter().map(|rasterizer| Work {
            operations: 1,
            run: Box::new(|| {
                black_box((rasterizer.fill)(black_box(&input)));
            }),
        });
        let spreads = interleaved(works.collect(), ROUNDS, TURN);
        for (rasterizer, spread) in RASTERIZERS.iter().zip(spreads) {
            if let Some(folder) = &folder {
                save(rasterizer, &input, Path::new(folder))?;
            }
            print(rasterizer, &input, &spread);
        }
    }
    Ok(())
}

fn print(rasterizer: &Rasterizer, input: &Input, spread: &Spread) {
    let (figure, size, name) = (input.figure.name(), input.size, rasterizer.name);
    let Spread {
        median,
        low,
        high,
        rounds,
    } = spread;
    println!("{figure},{size},{name},{median:.1},{low:.1},{high:.1},{rounds}");
}

fn save(rasterizer: &Rasterizer, input: &Input, folder: &Path) -> io::Result<()> {
    let mut file = format!("P5 {0} {0} 255\n", input.size).into_bytes();
    file.extend((rasterizer.fill)(input));
    let name = format!("{}-{}-{}.pgm", input.figure.name(), input.size, rasterizer.name);
    fs::write(folder.join(name), file)
}
