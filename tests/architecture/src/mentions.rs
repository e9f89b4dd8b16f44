//! Where variants of an enum are named, read from the tokens of the sources: in `match`, `if let`, `matches!`, a comparison or a value alike;
//! and where a method without arguments is called.
//!
//! Code that stands behind `#[cfg(test)]` does not count, nor do the files of modules that are declared there. An alias of the enum and a
//! glob import count as a mention each, since what follows them cannot be told.

use crate::sources::Source;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};

/// The number of mentions of variants of `name` in each of the files of a crate that have some.
pub fn mentions(sources: &[Source], name: &str) -> Result<BTreeMap<String, usize>, String> {
    counted(sources, &|tokens| match tokens {
        [TokenTree::Ident(word), behind @ ..] if word == name => mentioned(behind),
        _ => 0,
    })
}

/// The number of calls `.name()` in each of the files of a crate that have some.
pub fn calls(sources: &[Source], name: &str) -> Result<BTreeMap<String, usize>, String> {
    counted(sources, &|tokens| match tokens {
        [TokenTree::Punct(mark), TokenTree::Ident(word), TokenTree::Group(arguments), ..] => {
            let is_call = mark.as_char() == '.' && word == name && arguments.delimiter() == Delimiter::Parenthesis;
            usize::from(is_call && arguments.stream().is_empty())
        }
        _ => 0,
    })
}

/// How many finds begin with the first of some tokens.
type Count<'a> = &'a dyn Fn(&[TokenTree]) -> usize;

/// The number of finds in each of the files of a crate that have some.
fn counted(sources: &[Source], count: Count<'_>) -> Result<BTreeMap<String, usize>, String> {
    let mut found = BTreeMap::new();
    let mut test_modules: BTreeSet<Vec<String>> = BTreeSet::new();
    for source in sources {
        let tokens: TokenStream = source.text.parse().map_err(|error| format!("{}: {error}", source.path))?;
        let mut file = File { count, found: 0, test_modules: Vec::new() };
        file.read(tokens);
        test_modules.extend(file.test_modules.iter().map(|module| {
            let mut path = source.module_path();
            path.push(module.clone());
            path
        }));
        if file.found > 0 {
            found.insert(source.path.clone(), (source.module_path(), file.found));
        }
    }
    let is_test = |path: &[String]| (1..=path.len()).any(|length| test_modules.contains(&path[..length]));
    let counted = found.into_iter().filter(|(_, (path, _))| !is_test(path));
    Ok(counted.map(|(file, (_, count))| (file, count)).collect())
}

/// What is found in one file.
struct File<'a> {
    count: Count<'a>,
    found: usize,
    /// Modules declared here that are for tests alone.
    test_modules: Vec<String>,
}

impl File<'_> {
    fn read(&mut self, stream: TokenStream) {
        let tokens: Vec<TokenTree> = stream.into_iter().collect();
        let mut k = 0;
        while k < tokens.len() {
            if is_test_attribute(&tokens[k..]) {
                k = self.skip_item(&tokens, k + 2);
                continue;
            }
            if let TokenTree::Group(group) = &tokens[k] {
                self.read(group.stream());
            }
            self.found += (self.count)(&tokens[k..]);
            k += 1;
        }
    }

    /// The place behind the item that begins at token `k`: a block, or a semicolon.
    fn skip_item(&mut self, tokens: &[TokenTree], k: usize) -> usize {
        let is_end = |token: &TokenTree| match token {
            TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
            TokenTree::Punct(mark) => mark.as_char() == ';',
            _ => false,
        };
        let end = (k..tokens.len()).find(|&j| is_end(&tokens[j])).unwrap_or(tokens.len());
        if let (Some(module), Some(TokenTree::Ident(name))) = (
            (k..end).find(|&j| matches!(&tokens[j], TokenTree::Ident(word) if word == "mod")),
            tokens.get(end.saturating_sub(1)),
        ) && module + 2 == end
        {
            self.test_modules.push(name.to_string());
        }
        end + 1
    }
}

/// Whether `#[cfg(test)]` stands at the beginning of `tokens`.
fn is_test_attribute(tokens: &[TokenTree]) -> bool {
    matches!(tokens, [TokenTree::Punct(mark), TokenTree::Group(attribute), ..]
        if mark.as_char() == '#' && attribute.stream().to_string().replace(' ', "") == "cfg(test)")
}

/// The number of variants that `tokens` name, which stand behind the name of the enum.
fn mentioned(tokens: &[TokenTree]) -> usize {
    let is_colon = |k: usize| matches!(tokens.get(k), Some(TokenTree::Punct(mark)) if mark.as_char() == ':');
    match tokens.first() {
        Some(TokenTree::Ident(word)) if word == "as" => return 1,
        _ if !(is_colon(0) && is_colon(1)) => return 0,
        _ => {}
    }
    match tokens.get(2) {
        Some(TokenTree::Ident(variant)) => usize::from(is_variant(&variant.to_string())),
        Some(TokenTree::Punct(mark)) => usize::from(mark.as_char() == '*'),
        Some(TokenTree::Group(several)) => {
            let named = several.stream().into_iter();
            named.filter(|token| matches!(token, TokenTree::Ident(word) if is_variant(&word.to_string()))).count()
        }
        _ => 0,
    }
}

/// Whether a name is that of a variant, not of a constant or a function.
fn is_variant(name: &str) -> bool {
    name.starts_with(char::is_uppercase) && name.contains(char::is_lowercase)
}
