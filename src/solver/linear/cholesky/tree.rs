//! The elimination tree of supernodes, and how threads share it.

use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use std::cmp::Ordering;
use std::ops::Range;

/// The elimination tree of supernodes; words as in [`super::subtrees`]. Supernodes are numbered so that children come
/// before their parents.
///
/// The elimination may end before the last column. Columns from there on are *kept*: they are no supernodes of the tree,
/// but take updates as one more, after the last.
pub(in crate::solver::linear) struct Tree {
    /// First column of each supernode, the first kept column, and the number of columns.
    pub begin: Vec<usize>,
    /// First value of each supernode, and the number of values.
    pub value: Vec<usize>,
    /// Supernodes that update each supernode, and those that update kept columns.
    pub sources: Vec<Vec<u32>>,
    /// Rows below the last supernode: where the elimination ends within it, its own columns are the first of them.
    last_rows: Vec<u32>,
    /// The parent of each supernode; of a root their number.
    pub parent: Vec<usize>,
    children: Vec<Vec<usize>>,
    roots: Vec<usize>,
    /// Of the subtree that each supernode is the root of: its first supernode,
    pub first: Vec<usize>,
    /// how many it has,
    size: Vec<usize>,
    /// their work, in multiplications but for a factor,
    pub work: Vec<f64>,
    /// and their values.
    entries: Vec<f64>,
}

/// Roots of subtrees, a list for each thread, and the supernodes above them, ascending.
pub(in crate::solver::linear) type Split = (Vec<Vec<usize>>, Vec<usize>);

impl Tree {
    /// The tree of a factor whose structure is known, of which the first `eliminated` columns are wanted.
    pub fn new(symbolic: &SymbolicSupernodalCholesky<u32>, eliminated: usize) -> Self {
        let starts = symbolic.supernode_begin().iter().map(|b| *b as usize);
        let mut begin: Vec<usize> = (starts.take(symbolic.n_supernodes()))
            .take_while(|start| *start < eliminated)
            .collect();
        let count = begin.len();
        begin.extend([eliminated, symbolic.nrows()]);
        // Of kept columns: the one after the last.
        let mut owner = vec![count as u32; symbolic.nrows()];
        for (s, ends) in begin.windows(2).take(count).enumerate() {
            owner[ends[0]..ends[1]].fill(s as u32);
        }
        let values = symbolic.col_ptr_for_val().iter().map(|v| *v as usize);
        let mut value: Vec<usize> = values.take(count + 1).collect();
        let mut last_rows = Vec::new();
        if let Some(last) = count.checked_sub(1) {
            let end = symbolic.supernode_end()[last];
            last_rows.extend(eliminated as u32..end);
            last_rows.extend(symbolic.supernode(last).pattern());
            let columns = eliminated - begin[last];
            value[count] = value[last] + columns * (columns + last_rows.len());
        }
        let mut tree = Self {
            value,
            last_rows,
            sources: vec![Vec::new(); count + 1],
            parent: vec![count; count],
            children: vec![Vec::new(); count],
            roots: Vec::new(),
            first: (0..count).collect(),
            size: vec![1; count],
            work: vec![0.0; count],
            entries: vec![0.0; count],
            begin,
        };
        for s in 0..count {
            let rows = tree.rows(symbolic, s);
            let (columns, height) = (tree.columns(s), tree.columns(s) + rows.len());
            let mut above: Vec<u32> = rows.iter().map(|r| owner[*r as usize]).collect();
            above.dedup();
            let parent = above.first().map_or(count, |parent| *parent as usize);
            for above in above {
                tree.sources[above as usize].push(s as u32);
            }
            let own: f64 = (0..columns).map(|c| ((height - c) as f64).powi(2)).sum();
            tree.work[s] += own;
            tree.entries[s] += (tree.value[s + 1] - tree.value[s]) as f64;
            tree.parent[s] = parent;
            if parent == count {
                tree.roots.push(s);
                continue;
            }
            tree.children[parent].push(s);
            tree.work[parent] += tree.work[s];
            tree.entries[parent] += tree.entries[s];
            tree.size[parent] += tree.size[s];
            tree.first[parent] = tree.first[parent].min(tree.first[s]);
        }
        tree
    }

    /// Number of supernodes.
    pub fn len(&self) -> usize {
        self.children.len()
    }

    /// The kept columns.
    pub fn kept(&self) -> Range<usize> {
        self.begin[self.len()]..self.begin[self.len() + 1]
    }

    /// Columns of a supernode, or number of kept ones after the last.
    pub fn columns(&self, s: usize) -> usize {
        self.begin[s + 1] - self.begin[s]
    }

    /// Rows of a supernode below its triangle, ascending, in the order of elimination.
    pub fn rows<'a>(
        &'a self,
        symbolic: &'a SymbolicSupernodalCholesky<u32>,
        s: usize,
    ) -> &'a [u32] {
        match (s + 1).cmp(&self.len()) {
            Ordering::Less => symbolic.supernode(s).pattern(),
            Ordering::Equal => &self.last_rows,
            Ordering::Greater => &[],
        }
    }

    /// Do the supernodes of the subtree follow each other?
    fn is_run(&self, root: usize) -> bool {
        self.first[root] + self.size[root] == root + 1
    }

    /// Roots of the subtrees that threads factor by themselves, and the supernodes above them, both ascending.
    pub fn split(&self, threads: usize) -> (Vec<usize>, Vec<usize>) {
        let (shares, top) = self.divide(threads, &self.work);
        let mut subtrees: Vec<usize> = shares.into_iter().flatten().collect();
        subtrees.sort_unstable();
        (subtrees, top)
    }

    /// The same for a solution: of each thread the roots of its subtrees, about even in entries.
    pub fn shares(&self, threads: usize) -> Split {
        self.divide(threads, &self.entries)
    }

    /// Roots of subtrees, a list for each thread, and the supernodes above them, ascending; `load` is that of the subtree
    /// below each supernode.
    ///
    /// From the roots of the whole tree down: as long as the threads have not about the same to do, the heaviest
    /// subtree is opened, which puts its root above and its children in its place (Geist and Ng, Int. J. Parallel
    /// Programming 18 (1989) 291).
    fn divide(&self, threads: usize, load: &[f64]) -> Split {
        /// What the busiest thread may have to do above the mean, over all work below the roots.
        const MOST_UNEVEN: f64 = 0.005;
        let sum = |list: &[usize]| list.iter().map(|s| load[*s]).sum::<f64>();
        let total = sum(&self.roots);
        let (mut subtrees, mut top): (Vec<usize>, Vec<usize>) = (self.roots.clone(), Vec::new());
        let shares = loop {
            subtrees.sort_by(|a, b| load[*b].total_cmp(&load[*a]));
            let mut shares = vec![(0.0f64, Vec::new()); threads];
            for s in &subtrees {
                let least = shares.iter_mut().min_by(|a, b| a.0.total_cmp(&b.0));
                if let Some((sum, share)) = least {
                    *sum += load[*s];
                    share.push(*s);
                }
            }
            let most = shares.iter().map(|share| share.0).fold(0.0, f64::max);
            let even = most - sum(&subtrees) / threads as f64 <= MOST_UNEVEN * total;
            let opened = match subtrees.iter().position(|s| !self.is_run(*s)) {
                Some(scattered) => scattered,
                None if even => break shares,
                None => 0,
            };
            let opened = subtrees.remove(opened);
            subtrees.extend(&self.children[opened]);
            top.push(opened);
        };
        top.sort_unstable();
        (shares.into_iter().map(|share| share.1).collect(), top)
    }
}
