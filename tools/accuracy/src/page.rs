//! The report as one page that needs nothing beside it.

use std::fmt::Write;

use super::{
    axis::{Chapter, Context, Entry, Summary},
    digits::digits,
    figures::{Cost, charts},
    host, lead, names, pareto,
};

const STYLE: &str = "
body{font:15px/1.45 system-ui,sans-serif;max-width:1600px;margin:2em auto;padding:0 1em;color:#222}
h1,h2,h3{line-height:1.2}h2{border-top:2px solid #ddd;padding-top:1em;margin-top:2em}
table{border-collapse:collapse;font-size:13px;margin:.6em 0}
th,td{padding:.2em .7em;border-bottom:1px solid #e4e4e4;text-align:right;vertical-align:middle}
th{text-align:right;font-weight:600;background:#f5f5f5}th.text,td.text{text-align:left}
td.dominated{color:#999}td,.spread{white-space:nowrap}td.pictures{text-align:left}td.facts{white-space:normal;text-align:left}
td.strong{font-weight:700}.charts{display:flex;flex-wrap:wrap;gap:8px}
.charts svg{flex:1 1 600px;min-width:0;height:auto;border:1px solid #eee}
.diagram svg{width:100%;height:auto;border:1px solid #eee}
.pixels{image-rendering:pixelated;border:1px solid #ddd;margin-right:4px;vertical-align:top;background:#fff}
.caption{font-size:12px;color:#777;white-space:normal;max-width:450px}
.note{background:#fff6d8;border-left:4px solid #e0b020;padding:.5em 1em}
nav.groups{font-size:13px}nav.groups a{margin-right:1.2em}.contents li{margin:.3em 0}
.answer{font-size:19px;max-width:60em}.steps{display:flex;flex-wrap:wrap;gap:16px;margin:1em 0}
.steps figure{margin:0}.steps figcaption{font-size:14px;margin-top:.3em}.command{font-size:13px;color:#555}";

/// The whole page.
pub fn html(chapters: &[Chapter], context: &Context<'_>) -> anyhow::Result<String> {
    let mut page = String::new();
    write!(
        page,
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\
         <meta name=\"viewport\" content=\"width=device-width\"><title>zrow: accuracy and its cost</title>\
         <style>{STYLE}</style></head><body>\n<h1>zrow: what accuracy costs</h1>\n"
    )?;
    page += &lead::html(chapters)?;
    add_contents(&mut page, chapters)?;
    for chapter in chapters {
        add_chapter(&mut page, chapter)?;
    }
    add_run(&mut page, context)?;
    page += "</body></html>\n";
    Ok(page)
}

/// A list of the chapters and of their groups.
fn add_contents(page: &mut String, chapters: &[Chapter]) -> anyhow::Result<()> {
    *page += "<h2 id=\"contents\">Contents</h2>\n<ol class=\"contents\">";
    for chapter in chapters {
        write!(page, "<li><a href=\"#{}\">{}</a>", chapter.name, escaped(chapter.title))?;
        add_groups(page, chapter)?;
        *page += "</li>\n";
    }
    *page += "<li><a href=\"#run\">How to read it, and what was run</a></li></ol>\n";
    Ok(())
}

/// How charts are read, what is missing, and the machine.
fn add_run(page: &mut String, context: &Context<'_>) -> anyhow::Result<()> {
    *page += "<h2 id=\"run\">How to read it, and what was run</h2>\n\
             <p>Each chart shows error against cost; left and low is good. The blue steps join the methods that no other one \
             beats in both; the others are grey. Where a chart says so, the area of a mark grows with the memory of a row. A \
             time is the median of rounds in which every method has its turn; the bar through its mark, and the column \
             \"middle half\", reach from the lower to the upper quartile of the rounds. In the tables a time or a count is grey \
             where another method has no more of the cost and no more error, and the name is grey where both are.</p>\n";
    if context.plan.quick {
        *page += "<p class=\"note\">A quick run: a fifth of the inputs, few short rounds. Its times and errors are coarse. Without \
                 <code>--quick</code> they are what the project quotes.</p>\n";
    }
    if let Some(why) = context.counted.missing() {
        writeln!(
            page,
            "<p class=\"note\">No instructions of the emulated chip: {}</p>",
            escaped(why)
        )?;
    }
    if let Some(when) = context.counted.recorded() {
        writeln!(
            page,
            "<p class=\"note\">Instructions and cycles of the emulated chip were not counted in this run, but {}.</p>",
            escaped(when)
        )?;
    }
    *page += "<table>";
    for (name, text) in host::facts() {
        write!(
            page,
            "<tr><td class=\"text\">{name}</td><td class=\"facts\"><code>{}</code></td></tr>",
            escaped(&text)
        )?;
    }
    *page += "</table>\n";
    Ok(())
}

fn add_chapter(page: &mut String, chapter: &Chapter) -> anyhow::Result<()> {
    writeln!(page, "<h2 id=\"{}\">{}</h2>", chapter.name, escaped(chapter.title))?;
    for paragraph in &chapter.about {
        writeln!(page, "<p>{}</p>", escaped(paragraph))?;
    }
    writeln!(
        page,
        "<p class=\"command\">This chapter alone: <code>cargo run --release -- accuracy --only {0}</code>; its figures are in \
         <code>{0}.csv</code> beside this page{1}.</p>",
        chapter.name,
        match (chapter.diagrams.is_empty(), chapter.entries.is_empty()) {
            (false, _) => ", its charts as SVG too",
            (true, false) => ", its charts as SVG and PNG too",
            (true, true) => "",
        }
    )?;
    for diagram in &chapter.diagrams {
        writeln!(
            page,
            "<h3>{}</h3>\n<div class=\"diagram\">{}</div>",
            escaped(&diagram.title),
            diagram.svg
        )?;
    }
    for summary in &chapter.summaries {
        add_summary(page, summary)?;
    }
    for group in chapter.groups() {
        write!(
            page,
            "<h3 id=\"{}\">{}</h3>\n<div class=\"charts\">",
            chapter.group_name(group),
            escaped(&group.replace('_', " "))
        )?;
        for (_, chart) in charts(chapter, group) {
            *page += &chart.svg()?;
        }
        *page += "</div>\n";
        add_table(page, chapter, &chapter.of_group(group))?;
    }
    Ok(())
}

/// Where the groups of a chapter are.
fn add_groups(page: &mut String, chapter: &Chapter) -> anyhow::Result<()> {
    if chapter.groups().len() > 1 {
        *page += "<nav class=\"groups\">";
        for group in chapter.groups() {
            write!(
                page,
                "<a href=\"#{}\">{}</a>",
                chapter.group_name(group),
                escaped(&group.replace('_', " "))
            )?;
        }
        *page += "</nav>\n";
    }
    Ok(())
}

fn add_summary(page: &mut String, summary: &Summary) -> anyhow::Result<()> {
    write!(page, "<h3>{}</h3>\n<table><tr>", escaped(&summary.title))?;
    for (index, column) in summary.columns.iter().enumerate() {
        let class = if index == 0 { " class=\"text\"" } else { "" };
        write!(page, "<th{class}>{}</th>", escaped(column))?;
    }
    *page += "</tr>\n";
    for row in &summary.rows {
        *page += "<tr>";
        for (index, cell) in row.iter().enumerate() {
            let class = match () {
                () if index == 0 => " class=\"text\"",
                () if cell.is_strong => " class=\"strong\"",
                () => "",
            };
            write!(page, "<td{class}>{}</td>", escaped(&cell.text))?;
        }
        *page += "</tr>\n";
    }
    *page += "</table>\n";
    Ok(())
}

fn add_table(page: &mut String, chapter: &Chapter, entries: &[&Entry]) -> anyhow::Result<()> {
    *page += "<table><tr><th class=\"text\">method</th>";
    for figure in chapter.figures.iter().chain(&chapter.memory) {
        write!(page, "<th>{}</th>", escaped(figure))?;
    }
    write!(
        page,
        "<th>ns for {0}</th><th>middle half of {1} rounds</th><th>instructions for {0}</th><th>cycles for {0}</th>{2}",
        escaped(chapter.operation),
        entries
            .iter()
            .filter_map(|entry| entry.time)
            .map(|time| time.rounds)
            .max()
            .unwrap_or_default(),
        if has_flash(chapter) {
            "<th>bytes of flash</th>"
        } else {
            ""
        }
    )?;
    let pictures = entries.iter().any(|entry| entry.picture.is_some());
    *page += if pictures {
        "<th class=\"text\">picture</th></tr>\n"
    } else {
        "</tr>\n"
    };
    let faint = dominated(entries, Cost::Time).into_iter();
    let faint = faint.zip(dominated(entries, Cost::Instructions));
    for (entry, faint) in entries.iter().zip(faint) {
        add_row(page, chapter, entry, faint)?;
    }
    *page += "</table>\n";
    Ok(())
}

/// Whether the flash of an entry was measured.
fn has_flash(chapter: &Chapter) -> bool {
    chapter.entries.iter().any(|entry| entry.chip.flash_bytes.is_some())
}

/// What has no cost is not held against the others; where none has, it is time that decides.
fn dominated(entries: &[&Entry], cost: Cost) -> Vec<bool> {
    let is_known = entries.iter().any(|entry| cost.of(entry).is_some());
    let cost = if is_known { cost } else { Cost::Time };
    let costs = entries
        .iter()
        .map(|entry| (entry.error(), cost.of(entry).unwrap_or(f64::INFINITY)));
    pareto::dominated(&costs.collect::<Vec<_>>())
}

/// Its costs are faint where they are dominated.
fn add_row(
    page: &mut String,
    chapter: &Chapter,
    entry: &Entry,
    (by_time, by_instructions): (bool, bool),
) -> anyhow::Result<()> {
    let class = |is_dominated| if is_dominated { " dominated" } else { "" };
    write!(
        page,
        "<tr><td class=\"text{}\">{}</td>",
        class(by_time && by_instructions),
        escaped(&names::title(&entry.method))
    )?;
    for figure in &entry.figures {
        write!(page, "<td>{}</td>", digits(*figure))?;
    }
    if chapter.memory.is_some() {
        write!(page, "<td>{}</td>", entry.memory_bytes)?;
    }
    match entry.time {
        Some(time) => write!(
            page,
            "<td class=\"cost{0}\">{1}</td><td class=\"spread{0}\">{2} to {3}</td>",
            class(by_time),
            digits(time.median),
            digits(time.low),
            digits(time.high)
        )?,
        None => *page += "<td></td><td></td>",
    }
    write!(
        page,
        "<td class=\"cost{}\">{}</td>",
        class(by_instructions),
        entry.chip.instructions.map(digits).unwrap_or_default()
    )?;
    write!(page, "<td>{}</td>", entry.chip.cycles.map(digits).unwrap_or_default())?;
    if has_flash(chapter) {
        write!(
            page,
            "<td>{}</td>",
            entry.chip.flash_bytes.map(digits).unwrap_or_default()
        )?;
    }
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

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
