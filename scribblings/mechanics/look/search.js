// A search box for the manual, in a browser without network.  It finds what (help "words") does,
// by the same table (mechanics/lang/help/search.rkt), which is in search-index.js, written when
// the manual is built and read when the box is first used.  Installed with Racket, the manual has
// Racket's own search box, and this one does not appear.

(function () {
  'use strict';

  var most = 10;              // findings shown
  var script = typeof document === 'undefined' ? null : document.currentScript;

  // ---------------------------------------------------------------------------
  // Words, as words.rkt has them

  function plain(text) {
    return text.normalize('NFKD').replace(/\p{Mn}/gu, '').replace(/’/g, "'").toLowerCase();
  }

  function allWords(table, text) {
    return plain(text).match(new RegExp(table.pattern, 'gu')) || [];
  }

  function stem(table, word) {
    if (/[0-9]/.test(word)) return word;
    return table.endings.reduce(function (w, e) {
      return w.replace(new RegExp(e[0], 'u'), e[1]);
    }, word);
  }

  function tellingWords(table, text) {
    var all = allWords(table, text);
    var telling = all.filter(function (w) { return table.joining.indexOf(w) < 0; });
    return telling.length ? telling : all;
  }

  function once(list) {
    return list.filter(function (x, i) { return list.indexOf(x) === i; });
  }

  // Phrases are taken for others.
  function askedWords(table, text) {
    var stems = once(tellingWords(table, text).map(function (w) { return stem(table, w); }));
    var spaced = table.phrases.reduce(function (t, p) {
      return t.split(' ' + p[0] + ' ').join(' ' + p[1] + ' ');
    }, ' ' + stems.join(' ') + ' ');
    return once(spaced.split(' ').filter(Boolean));
  }

  // ---------------------------------------------------------------------------
  // Finding, as search.rkt does: a finding is [kind, title, where, sentence, address].

  function share(table, w, term) {
    if (w === term) return 1;
    if (hasOwn(table.synonyms, w) && table.synonyms[w].indexOf(term) >= 0) return 2;
    if (/^[0-9.]+$/.test(w)) return 0;
    if (w.length >= 3 && term.startsWith(w)) return 3;
    if (term.length >= 4 && w.length - term.length <= 2 && w.startsWith(term)) return 4;
    return 0;
  }

  function hasOwn(object, key) { return Object.prototype.hasOwnProperty.call(object, key); }

  // A map from places to weights.
  function weightsOf(table, w) {
    var weights = new Map();
    Object.keys(table.words).forEach(function (term) {
      var part = share(table, w, term);
      if (part === 0) return;
      var postings = atob(table.words[term]);
      for (var i = 0; i < postings.length; i += 3) {
        var k = 256 * postings.charCodeAt(i) + postings.charCodeAt(i + 1);
        var weight = Math.floor(postings.charCodeAt(i + 2) / part);
        weights.set(k, Math.max(weight, weights.get(k) || 0));
      }
    });
    return weights;
  }

  function bonus(table, k, text) {
    var f = table.findings[k], typed = text.trim();
    var named = f[0] === 'page' ||
        (f[0] === 'name' &&
         ['mechanics', 'mechanics/scmutils', 'mechanics/book'].indexOf(f[2]) >= 0);
    if (named && f[1] === typed) return table.priors[k] + 2000;
    if (named && (plain(f[1]) === plain(typed) ||
                  plain(f[1]) === tellingWords(table, typed).join(' '))) {
      return table.priors[k] + 1000;
    }
    return table.priors[k];
  }

  // -> { found, all }: all findings, the best first, and whether they have all words
  function find(table, text) {
    var words = askedWords(table, text), scores = new Map(), best = 0;
    words.forEach(function (w) {
      weightsOf(table, w).forEach(function (weight, k) {
        var s = scores.get(k) || [0, 0];
        scores.set(k, [s[0] + 1, s[1] + weight]);
        best = Math.max(best, s[0] + 1);
      });
    });
    var found = [];
    scores.forEach(function (s, k) {
      if (s[0] === best) found.push([s[1] + bonus(table, k, text), k]);
    });
    found.sort(function (a, b) { return b[0] - a[0] || a[1] - b[1]; });
    return { found: oneOfEachPage(found.map(function (f) { return table.findings[f[1]]; })),
             all: best === words.length };
  }

  function oneOfEachPage(found) {
    var seen = new Set();
    return found.filter(function (f) {
      if (f[0] !== 'page' && f[0] !== 'section') return true;
      var page = f[2].split('#')[0];
      if (seen.has(page)) return false;
      seen.add(page);
      return true;
    });
  }

  // The text with the nearest word of a title in place of each that fits nothing, or null.
  function respelled(table, text) {
    var known = once([].concat.apply([], table.findings.map(function (f) {
      return allWords(table, f[1]);
    }))).sort();
    var changed = false;
    var spelt = tellingWords(table, text).map(function (w) {
      if (weightsOf(table, stem(table, w)).size) return w;
      changed = true;
      return nearest(w, known);
    });
    return changed && spelt.every(Boolean) ? spelt.join(' ') : null;
  }

  function nearest(word, known) {
    var best = null, least = Math.min(3, Math.floor((word.length + 1) / 4)) + 1;
    if (word.length < 4) return null;
    known.forEach(function (k) {
      var d = slips(word, k);
      if (d < least) { least = d; best = k; }
    });
    return best;
  }

  // Letters left out, put in, exchanged, or swapped with their neighbour.
  function slips(s, t) {
    var rows = [];
    for (var i = 0; i <= s.length; i++) {
      rows.push([i]);
      for (var j = 1; j <= t.length; j++) {
        rows[i][j] = i === 0 ? j : Math.min(rows[i - 1][j] + 1, rows[i][j - 1] + 1,
                                            rows[i - 1][j - 1] + (s[i - 1] === t[j - 1] ? 0 : 1));
        if (i > 1 && j > 1 && s[i - 1] === t[j - 2] && s[i - 2] === t[j - 1]) {
          rows[i][j] = Math.min(rows[i][j], rows[i - 2][j - 2] + 1);
        }
      }
    }
    return rows[s.length][t.length];
  }

  // Outside of a browser, for tests.
  if (!script) { module.exports = { find: find, respelled: respelled }; return; }

  // ---------------------------------------------------------------------------
  // Showing

  function make(tag, attributes, text) {
    var node = document.createElement(tag);
    for (var name in attributes) node.setAttribute(name, attributes[name]);
    if (text) node.appendChild(document.createTextNode(text));
    return node;
  }

  var introductions = { section: 'in: ', program: 'program: ', exercise: 'program: ' };

  function line(finding) {
    var item = make('li', {});
    var link = make('a', { href: finding[4] });
    var about = finding[3] || (finding[0] === 'name' ? finding[2] : finding[0]);
    link.appendChild(make('b', {}, finding[1]));
    link.appendChild(make('span', {}, ' ' + (introductions[finding[0]] || '') + about));
    item.appendChild(link);
    return item;
  }

  function note(text) { return make('li', { 'class': 'nothing' }, text); }

  function install(place) {
    var box = make('input', { id: 'searchbox', 'class': 'searchbox', type: 'search',
                              placeholder: 'search', autocomplete: 'off',
                              'aria-label': 'Search the manual',
                              title: 'A name, words, or the number of an exercise' });
    var list = make('ol', { id: 'found' });
    var table = null, chosen = 0;

    function show() {
      if (table === null) return;
      var text = box.value.trim();
      list.textContent = '';
      if (text) answer(text);
      list.className = text ? 'shown' : '';
      choose(0);
    }

    function answer(text) {
      var result = find(table, text);
      var otherwise = result.all ? null : respelled(table, text);
      if (otherwise) result = find(table, otherwise);
      result.found.filter(function (f) { return f[4]; }).slice(0, most)
        .forEach(function (f) { list.appendChild(line(f)); });
      if (otherwise) list.appendChild(note('found for: ' + otherwise));
      else if (result.found.length === 0) list.appendChild(note('nothing found'));
      else if (!result.all) list.appendChild(note('nothing has all of these words'));
    }

    function choose(n) {
      var items = list.getElementsByTagName('li');
      if (items.length === 0) return;
      if (items[chosen]) items[chosen].className = items[chosen].className.replace('chosen', '');
      chosen = Math.max(0, Math.min(n, items.length - 1));
      if (items[chosen].firstChild.href) items[chosen].className = 'chosen';
      if (items[chosen].scrollIntoView) items[chosen].scrollIntoView({ block: 'nearest' });
    }

    function leave() { list.className = ''; }

    function follow() {
      var item = list.getElementsByTagName('li')[chosen];
      if (item && item.firstChild.href) { leave(); window.location = item.firstChild.href; }
    }

    function read() {
      if (table !== null || document.getElementById('search-index')) return;
      window.mechanicsManual = function (all) { table = all; show(); };
      document.body.appendChild(make('script', {
        id: 'search-index', src: script.src.replace(/search\.js.*$/, 'search-index.js') }));
    }

    box.addEventListener('focus', function () { read(); show(); });
    box.addEventListener('input', function () { read(); show(); });
    box.addEventListener('keydown', function (event) {
      if (event.key === 'ArrowDown') choose(chosen + 1);
      else if (event.key === 'ArrowUp') choose(chosen - 1);
      else if (event.key === 'Enter') follow();
      else if (event.key === 'Escape') { box.value = ''; leave(); }
      else return;
      event.preventDefault();
    });
    document.addEventListener('click', function (event) {
      if (event.target !== box) leave();
    });

    place.className = 'searchform';
    place.appendChild(box);
    document.body.appendChild(list);
  }

  window.addEventListener('DOMContentLoaded', function () {
    var place = document.querySelector('.navsettop .nosearchform');
    if (place && !document.getElementById('searchbox')) install(place);
  });
})();
