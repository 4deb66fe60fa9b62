//! The report as one page that needs nothing beside it.

use std::fmt::Write;

use super::{
    axis::{Chapter, Context, Entry},
    figures::{Cost, charts},
    host, pareto,
};

const STYLE: &str = "
body{font:15px/1.45 system-ui,sans-serif;max-width:1180px;margin:2em auto;padding:0 1em;color:#222}
h1,h2,h3{line-height:1.2}h2{border-top:2px solid #ddd;padding-top:1em;margin-top:2em}
table{border-collapse:collapse;font-size:13px;margin:.6em 0}
th,td{padding:.2em .7em;border-bottom:1px solid #e4e4e4;text-align:right;vertical-align:middle}
th{text-align:right;font-weight:600;background:#f5f5f5}th.text,td.text{text-align:left}
tr.dominated td{color:#999}td.pictures{text-align:left;white-space:nowrap}
.charts{display:flex;flex-wrap:wrap;gap:8px}.charts svg{width:560px;height:auto;border:1px solid #eee}
.pixels{image-rendering:pixelated;border:1px solid #ddd;margin-right:4px;vertical-align:top;background:#fff}
.caption{font-size:12px;color:#777;white-space:normal;max-width:450px}
.note{background:#fff6d8;border-left:4px solid #e0b020;padding:.5em 1em}
nav a{margin-right:1.2em}";

/// The whole page.
pub fn html(chapters: &[Chapter], context: &Context<'_>) -> anyhow::Result<String> {
    let mut page = String::new();
    write!(
        page,
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>zrow: accuracy and its cost</title>\
         <style>{STYLE}</style></head><body>\n<h1>zrow: what accuracy costs</h1>\n"
    )?;
    if context.plan.quick {
        page += "<p class=\"note\">A quick run: a fifth of the inputs, few short rounds. Its figures are coarse, and nothing \
                 was counted in QEMU. Without <code>--quick</code> they are what the project quotes.</p>\n";
    }
    if let Some(why) = context.counted.missing() {
        writeln!(
            page,
            "<p class=\"note\">No instructions of the emulated chip: {}</p>",
            escaped(why)
        )?;
    }
    page += "<p>Each chart shows error against cost; left and low is good. The steps join the methods that no other one beats \
             in both, the others are faint. The area of a mark grows with the memory of a row. An error of 0 is drawn at the \
             bottom. Times are medians of rounds in which every method has its turn, bars are the middle half of the \
             rounds.</p>\n<nav>";
    for chapter in chapters {
        write!(page, "<a href=\"#{}\">{}</a>", chapter.name, escaped(chapter.title))?;
    }
    page += "</nav>\n<table>";
    for (name, text) in host::facts() {
        write!(
            page,
            "<tr><td class=\"text\">{name}</td><td class=\"text\"><code>{}</code></td></tr>",
            escaped(&text)
        )?;
    }
    page += "</table>\n";
    for chapter in chapters {
        add_chapter(&mut page, chapter)?;
    }
    page += "</body></html>\n";
    Ok(page)
}

fn add_chapter(page: &mut String, chapter: &Chapter) -> anyhow::Result<()> {
    writeln!(page, "<h2 id=\"{}\">{}</h2>", chapter.name, escaped(chapter.title))?;
    for paragraph in &chapter.about {
        writeln!(page, "<p>{}</p>", escaped(paragraph))?;
    }
    for group in chapter.groups() {
        write!(page, "<h3>{}</h3>\n<div class=\"charts\">", escaped(group))?;
        for (_, chart) in charts(chapter, group) {
            *page += &chart.svg()?;
        }
        *page += "</div>\n";
        add_table(page, chapter, &chapter.of_group(group))?;
    }
    Ok(())
}

fn add_table(page: &mut String, chapter: &Chapter, entries: &[&Entry]) -> anyhow::Result<()> {
    *page += "<table><tr><th class=\"text\">method</th>";
    for figure in chapter.figures.iter().chain(&chapter.memory) {
        write!(page, "<th>{}</th>", escaped(figure))?;
    }
    write!(
        page,
        "<th>ns for {0}</th><th>middle half</th><th>instructions for {0}</th>",
        escaped(chapter.operation)
    )?;
    let pictures = entries.iter().any(|entry| entry.picture.is_some());
    *page += if pictures {
        "<th class=\"text\">picture</th></tr>\n"
    } else {
        "</tr>\n"
    };
    let time_dominated = dominated(entries, Cost::Time);
    for (entry, dominated) in entries.iter().zip(time_dominated) {
        add_row(page, chapter, entry, dominated)?;
    }
    *page += "</table>\n";
    Ok(())
}

/// What has no cost is not held against the others.
fn dominated(entries: &[&Entry], cost: Cost) -> Vec<bool> {
    let costs = entries
        .iter()
        .map(|entry| (entry.error(), cost.of(entry).unwrap_or_default()));
    pareto::dominated(&costs.collect::<Vec<_>>())
}

fn add_row(page: &mut String, chapter: &Chapter, entry: &Entry, dominated: bool) -> anyhow::Result<()> {
    let class = if dominated { " class=\"dominated\"" } else { "" };
    write!(page, "<tr{class}><td class=\"text\">{}</td>", escaped(&entry.method))?;
    for figure in &entry.figures {
        write!(page, "<td>{}</td>", digits(*figure))?;
    }
    if chapter.memory.is_some() {
        write!(page, "<td>{}</td>", entry.memory_bytes)?;
    }
    match entry.time {
        Some(time) => write!(
            page,
            "<td>{}</td><td>{} to {}</td>",
            digits(time.median),
            digits(time.low),
            digits(time.high)
        )?,
        None => *page += "<td></td><td></td>",
    }
    write!(page, "<td>{}</td>", entry.instructions.map(digits).unwrap_or_default())?;
    if let Some(picture) = &entry.picture {
        write!(
            page,
            "<td class=\"pictures\">{}<div class=\"caption\">{}</div></td>",
            picture.html()?,
            escaped(&picture.caption)
        )?;
    }
    *page += "</tr>\n";
    Ok(())
}

/// Three digits that matter, or all before the point.
fn digits(number: f64) -> String {
    let size = number.abs();
    let text = match () {
        () if size >= 100.0 || number.fract() == 0.0 => format!("{number:.0}"),
        () if size >= 10.0 => format!("{number:.1}"),
        () if size >= 1.0 => format!("{number:.2}"),
        () => format!("{number:.3}"),
    };
    let (whole, fraction) = text.split_once('.').unwrap_or((&text, ""));
    let mut grouped = String::new();
    for (index, digit) in whole.chars().enumerate() {
        if index > 0 && (whole.len() - index).is_multiple_of(3) && !grouped.ends_with('-') {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    if fraction.is_empty() {
        grouped
    } else {
        format!("{grouped}.{fraction}")
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::digits;

    #[test]
    fn small_numbers_keep_three_digits() {
        let texts = [0.0, 0.1234, 7.0, 7.123, 42.42, 1234.6].map(digits);
        assert_eq!(texts, ["0", "0.123", "7", "7.12", "42.4", "1,235"]);
    }
}
