//! Sines and cosines: how exact they have to be, and what they cost.

use std::hint::black_box;

use zrow_methods::{TRIGONOMETRY, TRIGONOMETRY_COUNT, Trigonometry as Method};

use super::{
    axis::{Axis, Chapter, Context, Entry},
    errors::Errors,
    timing::{Spread, Work, interleaved},
};

/// Sine and cosine of an angle.
pub struct Trigonometry;

impl Axis for Trigonometry {
    fn name(&self) -> &'static str {
        "trigonometry"
    }

    fn counts(&self) -> Vec<String> {
        TRIGONOMETRY
            .iter()
            .flat_map(|method| [count(method), flash(method)])
            .collect()
    }

    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter> {
        let angles: Vec<u16> = (0..256u16).map(|index| index * 257).collect();
        let works = TRIGONOMETRY
            .iter()
            .map(|method| Work::on_each(&angles, |angle| _ = black_box((method.sine_cosine)(*angle))));
        let times = interleaved(works.collect(), context.plan);
        let entries = TRIGONOMETRY
            .iter()
            .zip(times)
            .map(|(method, time)| entry(method, time, context));
        Ok(Chapter {
            name: self.name(),
            title: "Sines and cosines",
            about: vec![
                "The sine and the cosine of each of 65,536 angles of a turn, in 2.30, against f64. The second figure is \
                 the largest error of the square of a vector's length when it is turned: what a model that is turned so \
                 shrinks or grows by, twice."
                    .to_owned(),
                "CORDIC (Volder 1959) turns a vector by smaller and smaller angles, with shifts and additions alone. The \
                 table has 129 entries of 16 bits for a quarter of a turn. Both f32 ways take the angle in radians; the \
                 chip that is counted has no floating-point unit in use."
                    .to_owned(),
                "Cost: one sine and one cosine of 256 angles around the turn. The memory is that of tables, in flash; \
                 flash is that of a program with nothing else for a Cortex-M3 at opt-level \"s\"."
                    .to_owned(),
            ],
            operation: "a sine and a cosine",
            memory: Some("bytes of tables"),
            figures: vec![
                "largest error in 1/1,000,000",
                "largest error of the squared length in 1/1,000,000",
                "rms error in 1/1,000,000",
            ],
            diagrams: Vec::new(),
            summaries: Vec::new(),
            entries: entries.collect(),
        })
    }
}

fn count(method: &Method) -> String {
    format!("{TRIGONOMETRY_COUNT}.{}", method.variant)
}

fn flash(method: &Method) -> String {
    format!("flash.sibling.{}", method.variant)
}

fn entry(method: &Method, time: Spread, context: &Context<'_>) -> Entry {
    let (mut errors, mut lengths) = (Errors::default(), Errors::default());
    for angle in 0..=u16::MAX {
        let [sine, cosine] = (method.sine_cosine)(angle).map(|number| f64::from(number) / f64::from(1 << 30));
        let (exact_sine, exact_cosine) = (f64::from(angle) * std::f64::consts::PI / 32_768.0).sin_cos();
        errors.add((sine - exact_sine) * 1e6);
        errors.add((cosine - exact_cosine) * 1e6);
        lengths.add((sine * sine + cosine * cosine - 1.0) * 1e6);
    }
    Entry {
        group: "all angles".to_owned(),
        method: method.name.to_owned(),
        figures: vec![errors.max(), lengths.max(), errors.rms()],
        memory_bytes: method.table_bytes,
        time: Some(time),
        chip: context.counted.with_flash(&count(method), &flash(method)),
        picture: None,
    }
}
