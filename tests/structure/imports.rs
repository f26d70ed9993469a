//! Which file of the library names what of which other, from the sources themselves.

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use syn::{Attribute, Item, Visibility};

/// A module by its names from the root on.
pub type Module = Vec<String>;

/// What the modules name.
pub struct Imports {
    /// Absolute paths that each module names, re-exports apart.
    paths: BTreeMap<Module, BTreeSet<Vec<String>>>,
    /// What each module exports under another's name: the name, and the path behind it.
    exports: BTreeMap<Module, BTreeMap<String, Vec<String>>>,
}

/// The files of the library.
pub fn sources() -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("src")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

fn module_of(path: &Path) -> Module {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let inner = path.strip_prefix(root).unwrap().with_extension("");
    let names = inner.iter().map(|name| name.to_str().unwrap().to_owned());
    names
        .filter(|name| name != "mod" && name != "lib")
        .collect()
}

impl Imports {
    pub fn read() -> Self {
        let mut files = BTreeMap::new();
        for path in sources()
            .iter()
            .filter(|path| !path.ends_with("src/main.rs"))
        {
            let text = fs::read_to_string(path).unwrap();
            files.insert(module_of(path), syn::parse_file(&text).unwrap().items);
        }
        let modules: BTreeSet<Module> = files.keys().cloned().collect();
        let mut imports = Self {
            paths: files
                .keys()
                .map(|module| (module.clone(), BTreeSet::new()))
                .collect(),
            exports: BTreeMap::new(),
        };
        for (module, items) in files {
            for item in items.into_iter().filter(|item| !is_test(attributes(item))) {
                let exported =
                    matches!(&item, Item::Use(u) if !matches!(u.vis, Visibility::Inherited));
                let mut found = Vec::new();
                named(item.to_token_stream(), &mut found);
                for path in found
                    .iter()
                    .filter_map(|path| absolute(&module, path, &modules))
                {
                    if exported {
                        let of = imports.exports.entry(module.clone()).or_default();
                        of.insert(path.last().unwrap().clone(), path);
                    } else {
                        imports.paths.get_mut(&module).unwrap().insert(path);
                    }
                }
            }
        }
        imports
    }

    pub fn modules(&self) -> BTreeSet<&[String]> {
        self.paths.keys().map(Vec::as_slice).collect()
    }

    pub fn paths(&self) -> &BTreeMap<Module, BTreeSet<Vec<String>>> {
        &self.paths
    }

    /// The module whose file defines what `path` names.
    fn definer<'a>(&'a self, path: &'a [String]) -> Option<&'a [String]> {
        let deepest = (0..=path.len())
            .rev()
            .find(|k| self.paths.contains_key(&path[..*k]))?;
        let module = &path[..deepest];
        let behind = path
            .get(deepest)
            .and_then(|item| self.exports.get(module)?.get(item));
        match behind {
            Some(behind) if behind.as_slice() != path => self.definer(behind),
            _ => Some(module),
        }
    }

    /// Every module beside every other that it names something of.
    pub fn edges(&self) -> BTreeSet<(&Module, &Module)> {
        let of = |module, path| {
            let (imported, _) = self.paths.get_key_value(self.definer(path)?)?;
            (imported != module).then_some((module, imported))
        };
        let all = self.paths.iter();
        all.flat_map(|(module, paths)| paths.iter().filter_map(move |path| of(module, path)))
            .collect()
    }

    /// Sets of modules that import each other, directly or by way of others.
    pub fn circles(&self) -> Vec<Vec<Module>> {
        let mut reached: BTreeMap<&Module, BTreeSet<&Module>> = BTreeMap::new();
        for (module, imported) in self.edges() {
            reached.entry(module).or_default().insert(imported);
        }
        let direct = reached.clone();
        for all in reached.values_mut() {
            let mut open: Vec<&Module> = all.iter().copied().collect();
            while let Some(module) = open.pop() {
                for next in direct.get(module).into_iter().flatten() {
                    if all.insert(next) {
                        open.push(next);
                    }
                }
            }
        }
        let mut circles: BTreeSet<Vec<Module>> = BTreeSet::new();
        for (module, all) in reached.iter().filter(|(module, all)| all.contains(*module)) {
            let back =
                |other: &&&Module| reached.get(**other).is_some_and(|far| far.contains(module));
            circles.insert(all.iter().filter(back).map(|m| (*m).clone()).collect());
        }
        circles.into_iter().collect()
    }
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Mod(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        _ => &[],
    }
}

fn is_test(attributes: &[Attribute]) -> bool {
    attributes
        .iter()
        .any(|a| a.path().is_ident("cfg") && a.to_token_stream().to_string().contains("test"))
}

/// Every path in the tokens, use trees spread out.
fn named(tokens: TokenStream, found: &mut Vec<Vec<String>>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut at = 0;
    while at < tokens.len() {
        match &tokens[at] {
            TokenTree::Ident(_) => at = path(&tokens, at, &[], found),
            TokenTree::Group(group) => {
                named(group.stream(), found);
                at += 1;
            }
            _ => at += 1,
        }
    }
}

/// Reads the path that begins at `at`, and returns where it ends.
fn path(
    tokens: &[TokenTree],
    mut at: usize,
    before: &[String],
    found: &mut Vec<Vec<String>>,
) -> usize {
    let mut names = before.to_vec();
    while let Some(TokenTree::Ident(name)) = tokens.get(at) {
        names.push(name.to_string());
        at += 1;
        let colon =
            |at: usize| matches!(tokens.get(at), Some(TokenTree::Punct(p)) if p.as_char() == ':');
        if !(colon(at) && colon(at + 1)) {
            break;
        }
        at += 2;
        if let Some(TokenTree::Group(tree)) = tokens.get(at) {
            let inner: Vec<TokenTree> = tree.stream().into_iter().collect();
            let is_comma = |t: &TokenTree| matches!(t, TokenTree::Punct(p) if p.as_char() == ',');
            for one in inner.split(is_comma).filter(|one| !one.is_empty()) {
                path(one, 0, &names, found);
            }
            return at + 1;
        }
    }
    found.push(names);
    at
}

/// A path from the root on; `None` for what is not of this library.
fn absolute(module: &Module, path: &[String], modules: &BTreeSet<Module>) -> Option<Vec<String>> {
    let mut base = module.clone();
    let mut rest = path;
    match rest.first()?.as_str() {
        "crate" => {
            base.clear();
            rest = &rest[1..];
        }
        "self" => rest = &rest[1..],
        "super" => {
            while rest.first().is_some_and(|name| name == "super") {
                base.pop();
                rest = &rest[1..];
            }
        }
        child => {
            base.push(child.to_owned());
            if rest.len() < 2 || !modules.contains(&base) {
                return None;
            }
            rest = &rest[1..];
        }
    }
    // `pub(super)` names nothing.
    if rest.is_empty() {
        return None;
    }
    base.extend(rest.iter().cloned());
    Some(base)
}
