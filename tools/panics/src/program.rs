//! A linked program as a graph: its functions, its data, and what refers to what.
//!
//! The linker keeps the relocations (`--emit-relocs`), so every call, every jump to another function and every pointer to
//! one is known with its place. The debug information tells which functions are inlined at a place.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet, VecDeque};

use addr2line::{
    Context,
    gimli::{self, Dwarf, EndianSlice, LittleEndian},
};
use anyhow::{Context as _, ensure};
use object::{File, Object, ObjectSection, ObjectSymbol, RelocationTarget, SectionKind, SymbolKind};

use super::names::{demangled, is_exercise, is_ours, is_panic};

type Bytes<'b> = EndianSlice<'b, LittleEndian>;

/// A function, and where in it the next one is called.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Frame {
    pub function: String,
    /// Source file and line, where known.
    pub location: Option<(String, u32)>,
}

/// A way from an exercise to a panic.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The functions that end in the panic and are neither zrow's nor the firmware's, the panic first.
    pub panic: Vec<String>,
    /// Who calls them, from the inside to the exercise.
    pub callers: Vec<Frame>,
}

impl Finding {
    /// The innermost caller whose source is zrow's or the firmware's.
    pub fn culprit(&self) -> Option<&Frame> {
        self.callers.iter().find(|frame| is_ours(&frame.function))
    }
}

/// A function, or a piece of data, which may hold pointers to functions.
#[derive(Debug)]
struct Item {
    end: u64,
    /// Several where equal functions were merged.
    names: Vec<String>,
}

/// A place that refers to an item.
#[derive(Clone, Copy, Debug)]
struct Reference {
    place: u64,
    /// The address where the referring item begins.
    from: u64,
}

/// A linked program. Items are known by the addresses where they begin.
pub struct Program<'b> {
    items: BTreeMap<u64, Item>,
    references: HashMap<u64, Vec<Reference>>,
    debug: Context<Bytes<'b>>,
    /// Bytes of machine code.
    pub text: u64,
    /// Functions of zrow in the program, inlined ones too: as the source has them, generic ones once.
    pub functions_of_zrow: usize,
}

impl<'b> Program<'b> {
    /// Reads a program with symbols, debug information and relocations.
    ///
    /// # Errors
    ///
    /// Something of that is missing.
    pub fn parse(bytes: &'b [u8]) -> anyhow::Result<Self> {
        let elf = File::parse(bytes)?;
        let items = items(&elf)?;
        let references = references(&elf, &items)?;
        ensure!(!references.is_empty(), "the program was linked without --emit-relocs");
        let text = elf.section_by_name(".text").context("no machine code")?.size();
        let functions_of_zrow = functions_of_zrow(&dwarf(&elf)?)?;
        ensure!(functions_of_zrow > 0, "the program has no debug information");
        Ok(Self {
            items,
            references,
            debug: Context::from_dwarf(dwarf(&elf)?)?,
            text,
            functions_of_zrow,
        })
    }

    /// The functions of the firmware that are linked.
    pub fn exercises(&self) -> impl Iterator<Item = &str> {
        self.names().filter(|name| is_exercise(name))
    }

    /// The functions that are linked and do nothing but panic.
    pub fn panics(&self) -> impl Iterator<Item = &str> {
        self.names().filter(|name| is_panic(name))
    }

    fn names(&self) -> impl Iterator<Item = &str> {
        self.items.values().flat_map(|item| &item.names).map(String::as_str)
    }

    /// Every place in zrow or in the firmware from which a panic is reached.
    pub fn findings(&self) -> Vec<Finding> {
        let is_panicking = |item: &Item| item.names.iter().any(|name| is_panic(name));
        let panics = self.items.iter().filter(|(_, item)| is_panicking(item));
        let mut queue: VecDeque<u64> = panics.map(|(&start, _)| start).collect();
        let mut seen: HashSet<u64> = queue.iter().copied().collect();
        // From what leads to a panic, one step towards it.
        let mut towards = HashMap::new();
        let mut findings = Vec::new();
        while let Some(item) = queue.pop_front() {
            for reference in self.references_to(item) {
                let mut callers = self.frames(reference.place);
                if callers.iter().any(|frame| is_ours(&frame.function)) {
                    callers.extend(self.way_to_exercise(reference.from));
                    let panic = self.chain(item, &towards);
                    findings.push(Finding { panic, callers });
                } else if seen.insert(reference.from) {
                    towards.insert(reference.from, item);
                    queue.push_back(reference.from);
                }
            }
        }
        findings
    }

    /// The shortest way from an exercise to a function with such a name, by calls and pointers, from the outside in; none where
    /// the exercise reaches no such function.
    ///
    /// # Errors
    ///
    /// There is no such exercise.
    pub fn way_from(&self, exercise: &str, is_wanted: impl Fn(&str) -> bool) -> anyhow::Result<Option<Vec<String>>> {
        let is_there = |(_, item): &(&u64, &Item)| item.names.iter().any(|name| name == exercise);
        let (&start, _) = self
            .items
            .iter()
            .find(is_there)
            .with_context(|| format!("no {exercise}"))?;
        let mut reached = BTreeMap::<u64, Vec<u64>>::new();
        for (&to, references) in &self.references {
            for reference in references {
                reached.entry(reference.from).or_default().push(to);
            }
        }
        let mut ways = HashMap::from([(start, vec![start])]);
        let mut queue = VecDeque::from([start]);
        while let Some(item) = queue.pop_front() {
            let way = ways[&item].clone();
            if self
                .items
                .get(&item)
                .is_some_and(|item| item.names.iter().any(|name| is_wanted(name)))
            {
                return Ok(Some(way.into_iter().map(|item| self.name(item)).collect()));
            }
            for &next in reached.get(&item).into_iter().flatten() {
                ways.entry(next).or_insert_with(|| {
                    queue.push_back(next);
                    [&way[..], &[next]].concat()
                });
            }
        }
        Ok(None)
    }

    /// From the panic to the item that leads to it.
    fn chain(&self, item: u64, towards: &HashMap<u64, u64>) -> Vec<String> {
        let steps = std::iter::successors(Some(item), |item| towards.get(item).copied());
        let mut chain: Vec<_> = steps.map(|item| self.name(item)).collect();
        // What almost every panic ends in says nothing.
        while chain.len() > 1 && chain.last().is_some_and(|name| name == "core::panicking::panic_fmt") {
            chain.pop();
        }
        chain.reverse();
        chain
    }

    /// The callers of a function up to the nearest exercise, from the inside out; none for an exercise.
    fn way_to_exercise(&self, function: u64) -> Vec<Frame> {
        let mut called_from = HashMap::from([(function, Vec::new())]);
        let mut queue = VecDeque::from([function]);
        while let Some(item) = queue.pop_front() {
            let way = called_from[&item].clone();
            if self.items[&item].names.iter().any(|name| is_exercise(name)) {
                return way;
            }
            for reference in self.references_to(item) {
                called_from.entry(reference.from).or_insert_with(|| {
                    queue.push_back(reference.from);
                    [way.clone(), self.frames(reference.place)].concat()
                });
            }
        }
        Vec::new()
    }

    fn references_to(&self, item: u64) -> &[Reference] {
        self.references.get(&item).map_or(&[], Vec::as_slice)
    }

    fn name(&self, item: u64) -> String {
        self.items
            .get(&item)
            .and_then(|item| item.names.first())
            .cloned()
            .unwrap_or_default()
    }

    /// The functions that are inlined at a place, from the inside out, and last the one that they are inlined in.
    fn frames(&self, place: u64) -> Vec<Frame> {
        let mut frames = Vec::new();
        if let Ok(mut inlined) = self.debug.find_frames(place).skip_all_loads() {
            while let Ok(Some(frame)) = inlined.next() {
                let name = frame.function.as_ref().and_then(|function| function.raw_name().ok());
                let location = frame
                    .location
                    .and_then(|location| Some((location.file?.to_owned(), location.line?)));
                frames.extend(name.map(|name| Frame {
                    function: demangled(&name),
                    location,
                }));
            }
        }
        if let (true, Some((&item, _))) = (frames.is_empty(), self.items.range(..=place).next_back()) {
            frames.push(Frame {
                function: self.name(item),
                location: None,
            });
        }
        frames
    }
}

/// Functions and data by address.
fn items(elf: &File<'_>) -> anyhow::Result<BTreeMap<u64, Item>> {
    let mut items = BTreeMap::<u64, Item>::new();
    for symbol in elf.symbols() {
        if symbol.size() > 0 && matches!(symbol.kind(), SymbolKind::Text | SymbolKind::Data) {
            let start = address(&symbol);
            let item = items.entry(start).or_insert(Item {
                end: start,
                names: Vec::new(),
            });
            item.end = item.end.max(start + symbol.size());
            item.names.push(demangled(symbol.name()?));
        }
    }
    Ok(items)
}

/// The address of the first byte of a symbol. The lowest bit of a Thumb function's address is a flag, and cleared here.
fn address<'d>(symbol: &impl ObjectSymbol<'d>) -> u64 {
    match symbol.kind() {
        SymbolKind::Text => symbol.address() & !1,
        _ => symbol.address(),
    }
}

/// The places that refer to each item from another one.
fn references(elf: &File<'_>, items: &BTreeMap<u64, Item>) -> anyhow::Result<HashMap<u64, Vec<Reference>>> {
    let item_at = |address: u64| {
        let (&start, item) = items.range(..=address).next_back()?;
        (address < item.end).then_some(start)
    };
    let mut references = HashMap::<u64, Vec<Reference>>::new();
    let kinds = [SectionKind::Text, SectionKind::ReadOnlyData, SectionKind::Data];
    for section in elf.sections().filter(|section| kinds.contains(&section.kind())) {
        let data = section.data()?;
        for (place, relocation) in section.relocations() {
            let RelocationTarget::Symbol(index) = relocation.target() else {
                continue;
            };
            let symbol = elf.symbol_by_index(index)?;
            let target = if symbol.kind() == SymbolKind::Section {
                // The address is in the data; that of a function is odd.
                let offset = usize::try_from(place - section.address())?;
                let word = data.get(offset..).and_then(|rest| rest.first_chunk());
                u64::from(u32::from_le_bytes(*word.context("a relocation outside its section")?)) & !1
            } else {
                address(&symbol)
            };
            if let (Some(from), Some(target)) = (item_at(place), item_at(target))
                && from != target
            {
                references.entry(target).or_default().push(Reference { place, from });
            }
        }
    }
    Ok(references)
}

fn dwarf<'b>(elf: &File<'b>) -> anyhow::Result<Dwarf<Bytes<'b>>> {
    Dwarf::load(|id| {
        let data = elf
            .section_by_name(id.name())
            .map(|section| section.data())
            .transpose()?;
        Ok(EndianSlice::new(data.unwrap_or_default(), LittleEndian))
    })
}

/// The functions of zrow that the debug information names, by name and line.
fn functions_of_zrow(dwarf: &Dwarf<Bytes<'_>>) -> anyhow::Result<usize> {
    let mut found = BTreeSet::new();
    let mut units = dwarf.units();
    while let Some(header) = units.next()? {
        let unit = dwarf.unit(header)?;
        let mut entries = unit.entries();
        while let Some(entry) = entries.next_dfs()? {
            let attribute = |name| entry.attr_value(name);
            let (Some(symbol), Some(line), true) = (
                attribute(gimli::DW_AT_linkage_name),
                attribute(gimli::DW_AT_decl_line).and_then(|line| line.udata_value()),
                entry.tag() == gimli::DW_TAG_subprogram,
            ) else {
                continue;
            };
            let name = demangled(&dwarf.attr_string(&unit, symbol)?.to_string_lossy());
            if is_ours(&name) && !is_exercise(&name) {
                let word = name
                    .split("::<")
                    .next()
                    .unwrap_or_default()
                    .rsplit("::")
                    .next()
                    .unwrap_or_default();
                found.insert((word.to_owned(), line));
            }
        }
    }
    Ok(found.len())
}
