//! What methods are called for people. Files for programs keep the names of the registry.

/// Authors, and what is written with capitals.
const NAMES: [&str; 19] = [
    "Bartlett",
    "Barsky",
    "Beck",
    "Bresenham",
    "Casteljau",
    "Cohen",
    "Cyrus",
    "DDA",
    "Gaussian",
    "Gouraud",
    "Greiner",
    "Hodgman",
    "Hormann",
    "Kuzmin",
    "Lee",
    "Liang",
    "Newton",
    "Nicholl",
    "Sutherland",
];

/// The name of a method, with what follows it, such as a tolerance.
pub fn title(method: &str) -> String {
    let (name, rest) = method.split_once(' ').unwrap_or((method, ""));
    let title = of_coverage(name).unwrap_or_else(|| words(name));
    if rest.is_empty() {
        title
    } else {
        format!("{title} {rest}")
    }
}

/// That of a method of antialiasing: how many samples it takes, and where.
fn of_coverage(name: &str) -> Option<String> {
    let whole = match name {
        "scanline_fill" => Some("no antialiasing"),
        "centre_sample" => Some("1 sample, in the centre"),
        "signed_area" => Some("exact area"),
        "inside_area" => Some("exact area, crossings too"),
        _ => None,
    };
    if let Some(whole) = whole {
        return Some(whole.to_owned());
    }
    if let Some(count) = name.strip_prefix("rooks_") {
        return Some(format!("{count} samples, n-rooks"));
    }
    if let Some(count) = name.strip_prefix("sub_scanlines_") {
        return Some(format!("{count} sub-scanlines"));
    }
    let grid = name.strip_prefix("grid_")?;
    Some(match grid.split_once('_') {
        Some((count, filter)) => format!("{count} x {count} samples, {} filter", words(filter)),
        None => format!("{count} x {count} samples", count = grid),
    })
}

/// The words of a name; of authors that follow each other the names are joined.
fn words(name: &str) -> String {
    let mut words = String::new();
    let mut was_author = false;
    for word in name.split('_') {
        let known = NAMES.iter().find(|known| known.eq_ignore_ascii_case(word));
        if !words.is_empty() {
            words.push(if was_author && known.is_some() { '-' } else { ' ' });
        }
        words += known.unwrap_or(&word);
        was_author = known.is_some();
    }
    words
}

#[cfg(test)]
mod tests {
    use zrow_methods::METHODS;

    use super::title;

    #[test]
    fn names_are_words() {
        let titles = [
            "rooks_16",
            "grid_8_bartlett",
            "grid_4",
            "sub_scanlines_4",
            "signed_area",
            "de_casteljau 1/8",
            "nicholl_lee_nicholl",
            "dda_fixed",
            "1/65536 px, grown window",
        ]
        .map(title);
        assert_eq!(
            titles,
            [
                "16 samples, n-rooks",
                "8 x 8 samples, Bartlett filter",
                "4 x 4 samples",
                "4 sub-scanlines",
                "exact area",
                "de Casteljau 1/8",
                "Nicholl-Lee-Nicholl",
                "DDA fixed",
                "1/65536 px, grown window",
            ]
        );
    }

    #[test]
    fn methods_of_antialiasing_have_no_names_of_code() {
        let titles: Vec<String> = METHODS.iter().map(|method| title(method.name)).collect();
        assert!(titles.iter().all(|title| !title.contains('_')), "{titles:?}");
        let mut once = titles.clone();
        once.sort();
        once.dedup();
        assert_eq!(once.len(), titles.len());
    }
}
