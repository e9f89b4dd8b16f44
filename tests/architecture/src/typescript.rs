//! TypeScript types of what Rust types are as JSON, read from the sources of the types and their `serde` attributes.
//!
//! What is not known here is an error: no type is written that could be wrong.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use syn::visit::{self, Visit};
use syn::{Attribute, Expr, Fields, Item, Lit, Meta, Type};

use crate::sources::Source;

/// Longest array that is written element by element.
const LONGEST_TUPLE: usize = 4;

/// The types of some crates, by their names.
pub struct Types {
    /// In the order of the crates, and within each of files and lines.
    all: Vec<Declared>,
}

/// A type with the place where it is declared.
struct Declared {
    /// Place of its crate in the list of crates.
    package: usize,
    file: String,
    name: String,
    item: Item,
    /// Read from JSON, not only written to it: what may be left out is optional.
    is_read: bool,
    /// Says so itself; aliases do not.
    is_message: bool,
}

impl Types {
    /// Those of the sources of some crates; files of tests do not count.
    ///
    /// # Errors
    /// A file that is not Rust.
    pub fn of(packages: &[Vec<Source>]) -> Result<Self, String> {
        let mut all = Vec::new();
        for (package, sources) in packages.iter().enumerate() {
            let mut sources: Vec<&Source> =
                sources.iter().filter(|source| !source.path.ends_with("tests.rs")).collect();
            sources.sort_by_key(|source| &source.path);
            for source in sources {
                let file = syn::parse_file(&source.text).map_err(|error| format!("{}: {error}", source.path))?;
                Collector { package, file: &source.path, all: &mut all }.visit_file(&file);
            }
        }
        Ok(Self { all })
    }

    /// The types of the first crate that are read from JSON or written to it, but for some, and what they hold.
    ///
    /// # Errors
    /// A type that is not known, two of one name, or an attribute that is not known.
    pub fn typescript(&self, but: &[&str]) -> Result<String, String> {
        let is_own = |one: &&Declared| one.package == 0 && one.is_message && !but.contains(&one.name.as_str());
        let mut open: Vec<&Declared> = self.all.iter().filter(is_own).collect();
        open.reverse();
        let mut written: BTreeMap<&str, &Declared> = BTreeMap::new();
        let mut text = String::new();
        while let Some(declared) = open.pop() {
            match written.get(declared.name.as_str()) {
                Some(known) if std::ptr::eq(*known, declared) => continue,
                Some(known) => {
                    return Err(format!("{} and {} both declare {}", known.file, declared.file, declared.name));
                }
                None => _ = written.insert(&declared.name, declared),
            }
            let mut named = BTreeSet::new();
            let own = declaration(declared, &mut named)
                .map_err(|reason| format!("{} in {}: {reason}", declared.name, declared.file))?;
            write!(text, "\n{own}").map_err(|error| error.to_string())?;
            for name in named.iter().rev() {
                open.push(self.find(name, declared)?);
            }
        }
        Ok(text)
    }

    /// The type that a name means in the file of another one: of that file, that crate, or the first crate that has it.
    fn find(&self, name: &str, from: &Declared) -> Result<&Declared, String> {
        let far = |one: &Declared| (one.package != from.package, one.file != from.file, one.package);
        let found: Vec<&Declared> = self.all.iter().filter(|one| one.name == name).collect();
        let least = found.iter().map(|one| far(one)).min();
        let mut nearest = found.into_iter().filter(|one| Some(far(one)) == least);
        match (nearest.next(), nearest.next()) {
            (Some(one), None) => Ok(one),
            (Some(one), Some(other)) => {
                Err(format!("{} and {} both declare {name}, which {} names", one.file, other.file, from.name))
            }
            _ => Err(format!("no type {name} is found, which {} names", from.name)),
        }
    }
}

struct Collector<'a> {
    package: usize,
    file: &'a str,
    all: &'a mut Vec<Declared>,
}

impl Collector<'_> {
    fn add(&mut self, name: &syn::Ident, attributes: &[Attribute], item: Item) {
        let derived: BTreeSet<String> =
            attributes.iter().filter(|one| one.path().is_ident("derive")).flat_map(words).collect();
        let (is_read, is_written) = (derived.contains("Deserialize"), derived.contains("Serialize"));
        let is_alias = matches!(item, Item::Type(_));
        if is_read || is_written || is_alias {
            let (file, name) = (self.file.to_owned(), name.to_string());
            // What is read of files and written to the page is what is written.
            let is_read = is_read && !is_written;
            self.all.push(Declared { package: self.package, file, name, item, is_read, is_message: !is_alias });
        }
    }
}

impl<'ast> Visit<'ast> for Collector<'_> {
    fn visit_item_mod(&mut self, module: &'ast syn::ItemMod) {
        let is_test =
            module.attrs.iter().any(|one| one.path().is_ident("cfg") && words(one).contains(&"test".to_owned()));
        if !is_test {
            visit::visit_item_mod(self, module);
        }
    }

    fn visit_item_struct(&mut self, item: &'ast syn::ItemStruct) {
        self.add(&item.ident, &item.attrs, Item::Struct(item.clone()));
    }

    fn visit_item_enum(&mut self, item: &'ast syn::ItemEnum) {
        self.add(&item.ident, &item.attrs, Item::Enum(item.clone()));
    }

    fn visit_item_type(&mut self, item: &'ast syn::ItemType) {
        self.add(&item.ident, &item.attrs, Item::Type(item.clone()));
    }
}

/// The last words of paths in the brackets of an attribute: `Serialize` of `derive(serde::Serialize)`.
fn words(attribute: &Attribute) -> Vec<String> {
    let mut found = Vec::new();
    _ = attribute.parse_nested_meta(|meta| {
        found.extend(meta.path.segments.last().map(|last| last.ident.to_string()));
        Ok(())
    });
    found
}

/// What the `serde` attributes of a type, a variant or a field say: keys with their values.
fn serde(attributes: &[Attribute], known: &[&str]) -> Result<BTreeMap<String, String>, String> {
    let mut found = BTreeMap::new();
    for attribute in attributes.iter().filter(|one| one.path().is_ident("serde")) {
        let parsed = attribute.parse_nested_meta(|meta| {
            let key = meta.path.require_ident()?.to_string();
            let value = if meta.input.peek(syn::Token![=]) {
                meta.value()?.parse::<syn::LitStr>()?.value()
            } else {
                String::new()
            };
            if !known.contains(&key.as_str()) {
                return Err(meta.error(format!("serde({key}) is not known")));
            }
            found.insert(key, value);
            Ok(())
        });
        parsed.map_err(|error| error.to_string())?;
    }
    match found.get("rename_all").map(String::as_str) {
        None | Some("snake_case") => Ok(found),
        Some(other) => Err(format!("serde(rename_all = \"{other}\") is not known")),
    }
}

/// The comment of documentation above something, with two or no spaces before it.
fn comment(attributes: &[Attribute], indent: &str) -> String {
    let lines = attributes.iter().filter_map(|one| match &one.meta {
        Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
            Expr::Lit(text) => match &text.lit {
                Lit::Str(text) => Some(text.value().trim().replace("*/", "* /")),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    });
    let text = lines.collect::<Vec<_>>().join(" ");
    if text.is_empty() { String::new() } else { format!("{indent}/** {text} */\n") }
}

/// A type as TypeScript declares it, and the names of the types in it.
fn declaration(declared: &Declared, named: &mut BTreeSet<String>) -> Result<String, String> {
    let name = &declared.name;
    match &declared.item {
        Item::Struct(item) => {
            serde(&item.attrs, &[])?;
            let about = comment(&item.attrs, "");
            match &item.fields {
                Fields::Named(_) => {
                    let (lines, parents) = fields(&item.fields, "  ", declared.is_read, named)?;
                    let parents =
                        if parents.is_empty() { String::new() } else { format!(" extends {}", parents.join(", ")) };
                    Ok(format!("{about}export interface {name}{parents} {{\n{}}}\n", lines.concat()))
                }
                Fields::Unnamed(inner) if inner.unnamed.len() == 1 => {
                    Ok(format!("{about}export type {name} = {};\n", typescript(&inner.unnamed[0].ty, named)?))
                }
                _ => Err("only fields with names are known".to_owned()),
            }
        }
        Item::Type(item) => {
            let about = comment(&item.attrs, "");
            Ok(format!("{about}export type {name} = {};\n", typescript(&item.ty, named)?))
        }
        Item::Enum(item) => variants(item, declared, named),
        _ => Err("neither struct nor enum".to_owned()),
    }
}

fn variants(item: &syn::ItemEnum, declared: &Declared, named: &mut BTreeSet<String>) -> Result<String, String> {
    let says = serde(&item.attrs, &["tag", "rename_all"])?;
    let is_plain = item.variants.iter().all(|variant| matches!(variant.fields, Fields::Unit));
    let tag = says.get("tag");
    if tag.is_none() && !is_plain {
        return Err("an enum with contents needs serde(tag)".to_owned());
    }
    let mut text = format!("{}export type {} =\n", comment(&item.attrs, ""), declared.name);
    for variant in &item.variants {
        let renamed = serde(&variant.attrs, &["rename"])?.remove("rename");
        let own = variant.ident.to_string();
        let own = renamed.unwrap_or(if says.contains_key("rename_all") { snake_case(&own) } else { own });
        let about = comment(&variant.attrs, "  ");
        let shape = match (tag, &variant.fields) {
            (None, _) => format!("'{own}'"),
            (Some(tag), Fields::Unit) => format!("{{ {tag}: '{own}' }}"),
            (Some(tag), Fields::Unnamed(inner)) if inner.unnamed.len() == 1 => {
                format!("({{ {tag}: '{own}' }} & {})", typescript(&inner.unnamed[0].ty, named)?)
            }
            (Some(tag), Fields::Named(_)) => {
                let (lines, parents) = fields(&variant.fields, "      ", declared.is_read, named)?;
                if !parents.is_empty() {
                    return Err("serde(flatten) in a variant is not known".to_owned());
                }
                format!("{{\n      {tag}: '{own}';\n{}    }}", lines.concat())
            }
            _ => return Err(format!("the contents of {own} have no names")),
        };
        writeln!(text, "{about}  | {shape}").map_err(|error| error.to_string())?;
    }
    Ok(text.trim_end().to_owned() + ";\n")
}

/// The lines of fields, and what is flattened among them.
fn fields(
    fields: &Fields,
    indent: &str,
    is_read: bool,
    named: &mut BTreeSet<String>,
) -> Result<(Vec<String>, Vec<String>), String> {
    let (mut lines, mut parents) = (Vec::new(), Vec::new());
    for field in fields {
        let says = serde(&field.attrs, &["default", "flatten", "rename", "skip_serializing_if"])?;
        let name = field.ident.as_ref().ok_or("a field has no name")?.to_string();
        let name = says.get("rename").cloned().unwrap_or_else(|| name.trim_start_matches("r#").to_owned());
        let inside = typescript(&field.ty, named)?;
        if says.contains_key("flatten") {
            parents.push(match inside.strip_suffix(" | null") {
                Some(inside) => format!("Partial<{inside}>"),
                None => inside,
            });
            continue;
        }
        // What is read may leave out what is nothing without it.
        let may_lack = is_read && (says.contains_key("default") || inside.ends_with(" | null"));
        let mark = if may_lack || says.contains_key("skip_serializing_if") { "?" } else { "" };
        lines.push(format!("{}{indent}{name}{mark}: {inside};\n", comment(&field.attrs, indent)));
    }
    Ok((lines, parents))
}

fn typescript(rust: &Type, named: &mut BTreeSet<String>) -> Result<String, String> {
    let listed = |inside: String| if inside.contains(" | ") { format!("({inside})[]") } else { format!("{inside}[]") };
    match rust {
        Type::Reference(reference) => typescript(&reference.elem, named),
        Type::Slice(slice) => Ok(listed(typescript(&slice.elem, named)?)),
        Type::Array(array) => {
            let inside = typescript(&array.elem, named)?;
            let Expr::Lit(length) = &array.len else { return Ok(listed(inside)) };
            let Lit::Int(length) = &length.lit else { return Ok(listed(inside)) };
            let length: usize = length.base10_parse().map_err(|error| error.to_string())?;
            Ok(if length <= LONGEST_TUPLE { format!("[{}]", vec![inside; length].join(", ")) } else { listed(inside) })
        }
        Type::Path(path) => {
            let last = path.path.segments.last().ok_or("a type without a name")?;
            let mut inside = Vec::new();
            if let syn::PathArguments::AngleBracketed(given) = &last.arguments {
                for one in &given.args {
                    if let syn::GenericArgument::Type(one) = one {
                        inside.push(typescript(one, named)?);
                    }
                }
            }
            let name = last.ident.to_string();
            match (name.as_str(), inside.as_slice()) {
                ("String" | "str", []) => Ok("string".to_owned()),
                ("bool", []) => Ok("boolean".to_owned()),
                ("f64" | "f32" | "usize" | "u64" | "u32" | "u16" | "u8" | "isize" | "i64" | "i32", []) => {
                    Ok("number".to_owned())
                }
                ("Option", [inside]) => Ok(format!("{inside} | null")),
                ("Box" | "Arc" | "Rc" | "Cow", [inside]) => Ok(inside.clone()),
                ("Vec", [inside]) => Ok(listed(inside.clone())),
                ("BTreeMap" | "HashMap", [key, inside]) if key == "string" => Ok(format!("Record<string, {inside}>")),
                (_, []) => {
                    named.insert(name.clone());
                    Ok(name)
                }
                _ => Err(format!("the type {name} is not known")),
            }
        }
        _ => Err("a type of this form is not known".to_owned()),
    }
}

/// `not_met` of `NotMet`.
fn snake_case(name: &str) -> String {
    let mut text = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !text.is_empty() {
            text.push('_');
        }
        text.extend(letter.to_lowercase());
    }
    text
}
