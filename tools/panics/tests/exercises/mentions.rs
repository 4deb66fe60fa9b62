//! What the exercises call, read from their source.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use syn::{
    AngleBracketedGenericArguments, Block, Expr, ExprCall, ExprPath, Ident, ItemMacro, ItemUse, Macro, PathArguments,
    QSelf, Token, TypePath, punctuated::Punctuated, visit::Visit,
};
use zrow_methods::registry::FAMILIES;

use super::api::{Item, type_name};

/// Exercises that go through more than the trait of their name. Any other trait is exercised by the function of its name.
const EXERCISED_BY: [(&str, &[&str]); 9] = [
    ("DrawAntialiased", &["antialiased_style"]),
    ("Clone", &["clone", "eq", "hash"]),
    ("PartialEq", &["eq", "hash"]),
    ("Display", &["display", "error"]),
    ("ExactSizeIterator", &["iterator"]),
    ("Dimensions", &["dimensions", "draw_target", "target", "styled_shape"]),
    ("DrawTarget", &["draw_target", "target"]),
    ("StyledDrawable", &["styled_shape", "stroked_shape"]),
    ("StyledDimensions", &["styled_shape", "stroked_shape"]),
];

/// The names that exercises call and instantiate.
#[derive(Debug, Default)]
pub struct Mentions {
    /// `of::name`, whatever generic arguments stand between the two.
    paths: BTreeSet<(String, String)>,
    /// Names that are called by themselves.
    calls: BTreeSet<String>,
    /// For each generic function the names in its arguments.
    arguments: BTreeMap<String, BTreeSet<String>>,
    /// The statement that each macro repeats for the algorithms of a family.
    repeated: BTreeMap<String, TokenStream>,
}

impl Mentions {
    pub fn read(&mut self, source: &str) {
        self.visit_file(&syn::parse_file(source).unwrap());
    }

    /// `<Type>::name`; in `<Type as Trait>::name` the trait's name is part of the path.
    fn add_qualified(&mut self, qualified: Option<&QSelf>, path: &syn::Path) {
        if let (Some(QSelf { ty, position: 0, .. }), Some(first)) = (qualified, path.segments.first()) {
            let of = type_name(ty);
            self.paths.extend(of.map(|of| (of, first.ident.to_string())));
        }
    }

    /// The statements of a macro that is called for each algorithm of a family: `zrow_methods::lines!(walk_each)`.
    fn visit_family(&mut self, call: &Macro) {
        let (Some(family), Ok(with)) = (call.path.segments.last(), call.parse_body::<Ident>()) else {
            return;
        };
        let family = FAMILIES.iter().find(|(name, _)| family.ident == name);
        let (Some((_, algorithms)), Some(statement)) = (family, self.repeated.get(&with.to_string()).cloned()) else {
            return;
        };
        for algorithm in *algorithms {
            let statements = with_item(statement.clone(), &algorithm.item.parse().unwrap());
            let block = Group::new(Delimiter::Brace, statements);
            let block: Block = syn::parse2(TokenTree::from(block).into()).unwrap();
            self.visit_block(&block);
        }
    }

    /// Whether the exercises go through something.
    pub fn include(&self, item: &Item) -> bool {
        let has_path = |of: &String, name: &String| self.paths.contains(&(of.clone(), name.clone()));
        match item {
            Item::Function {
                module,
                name,
                is_reexported,
            } => has_path(module, name) || *is_reexported && self.calls.contains(name),
            Item::Method { of, name } | Item::TraitFunction { of, name } => has_path(of, name),
            Item::Implementation { of, by } => {
                let own_name = snake_case(of);
                let exercises = EXERCISED_BY.iter().find(|(name, _)| name == of);
                let own = [own_name.as_str()];
                let exercises = exercises.map_or(&own[..], |(_, exercises)| exercises);
                exercises
                    .iter()
                    .any(|&exercise| self.arguments.get(exercise).is_some_and(|names| names.contains(by)))
            }
        }
    }
}

impl<'ast> Visit<'ast> for Mentions {
    /// An import calls nothing.
    fn visit_item_use(&mut self, _: &'ast ItemUse) {}

    fn visit_item_macro(&mut self, definition: &'ast ItemMacro) {
        if let (Some(name), Some(statement)) = (&definition.ident, repeated_statement(&definition.mac.tokens)) {
            self.repeated.insert(name.to_string(), statement);
        }
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let segments: Vec<_> = path.segments.iter().collect();
        for pair in segments.windows(2) {
            self.paths
                .insert((pair[0].ident.to_string(), pair[1].ident.to_string()));
        }
        for segment in &segments {
            if let PathArguments::AngleBracketed(arguments) = &segment.arguments
                && arguments.colon2_token.is_some()
            {
                let known = self.arguments.entry(segment.ident.to_string()).or_default();
                known.extend(words(arguments));
            }
        }
        if let [root, .., last] = segments[..]
            && root.ident == "zrow"
        {
            // From the registry: `zrow::scan::Lines::dda`.
            self.calls.insert(last.ident.to_string());
        }
        if let [only] = segments[..] {
            // A function that is handed over with its arguments: `iterator::<Runs>`.
            if matches!(&only.arguments, PathArguments::AngleBracketed(arguments) if arguments.colon2_token.is_some()) {
                self.calls.insert(only.ident.to_string());
            }
        }
        syn::visit::visit_path(self, path);
    }

    fn visit_expr_path(&mut self, expression: &'ast ExprPath) {
        self.add_qualified(expression.qself.as_ref(), &expression.path);
        syn::visit::visit_expr_path(self, expression);
    }

    fn visit_type_path(&mut self, path: &'ast TypePath) {
        self.add_qualified(path.qself.as_ref(), &path.path);
        syn::visit::visit_type_path(self, path);
    }

    fn visit_expr_call(&mut self, call: &'ast ExprCall) {
        if let Expr::Path(function) = &*call.func {
            self.calls.extend(function.path.get_ident().map(Ident::to_string));
        }
        syn::visit::visit_expr_call(self, call);
    }

    /// The arguments of `write!` and its like are expressions.
    fn visit_macro(&mut self, call: &'ast Macro) {
        self.visit_family(call);
        if let Ok(arguments) = call.parse_body_with(Punctuated::<Expr, Token![,]>::parse_terminated) {
            for argument in &arguments {
                self.visit_expr(argument);
            }
        }
        syn::visit::visit_macro(self, call);
    }
}

/// The statements within `$(...)+` in the last rule of a `macro_rules!` definition, given as its tokens.
fn repeated_statement(macro_rules: &TokenStream) -> Option<TokenStream> {
    let is_braced =
        |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
    let TokenTree::Group(rule) = macro_rules.clone().into_iter().filter(is_braced).last()? else {
        return None;
    };
    rule.stream().into_iter().find_map(|token| match token {
        TokenTree::Group(group) => Some(group.stream()),
        _ => None,
    })
}

/// Statements with the path of an algorithm in the place of `$($item)+`.
fn with_item(statements: TokenStream, item: &TokenStream) -> TokenStream {
    let mut tokens = statements.into_iter().peekable();
    let mut replaced = TokenStream::new();
    while let Some(token) = tokens.next() {
        match (token, tokens.peek()) {
            (TokenTree::Punct(dollar), Some(TokenTree::Group(_))) if dollar.as_char() == '$' => {
                // `($item)` and `+`.
                tokens.next();
                tokens.next();
                replaced.extend(item.clone());
            }
            (TokenTree::Group(group), _) => {
                let inner = with_item(group.stream(), item);
                replaced.extend([TokenTree::from(Group::new(group.delimiter(), inner))]);
            }
            (token, _) => replaced.extend([token]),
        }
    }
    replaced
}

/// All names in generic arguments.
fn words(arguments: &AngleBracketedGenericArguments) -> BTreeSet<String> {
    #[derive(Default)]
    struct Words(BTreeSet<String>);
    impl<'ast> Visit<'ast> for Words {
        fn visit_ident(&mut self, name: &'ast Ident) {
            self.0.insert(name.to_string());
        }
    }
    let mut words = Words::default();
    words.visit_angle_bracketed_generic_arguments(arguments);
    words.0
}

/// `FillSpan` as a function is called: `fill_span`.
fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    for (index, character) in name.chars().enumerate() {
        if character.is_uppercase() && index > 0 {
            snake.push('_');
        }
        snake.extend(character.to_lowercase());
    }
    snake
}
