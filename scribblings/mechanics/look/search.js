// A search box for the manual, in a browser without network: names, sections, and the first
// sentences of entries.  The list is in search-index.js, written when the manual is built;
// it is read when the box is first used.  Installed with Racket, the manual has Racket's own
// search box, and this one does not appear.

(function () {
  'use strict';

  var most = 30;              // entries shown
  var script = document.currentScript;

  // ---------------------------------------------------------------------------
  // Finding: an entry is [name, address, what it is, sentence].

  // How well a word fits an entry, less is better; -1: not at all.
  function distance(word, entry) {
    var name = entry[0].toLowerCase();
    if (name === word) return 0;
    if (name.indexOf(word) === 0) return 1;
    if (name.indexOf('-' + word) >= 0 || name.indexOf(' ' + word) >= 0) return 2;
    if (name.indexOf(word) >= 0) return 3;
    return entry[3].toLowerCase().indexOf(word) >= 0 ? 8 : -1;
  }

  // All words must occur; the worst of them decides, then the shorter name.
  function find(text, entries) {
    var words = text.toLowerCase().split(/\s+/).filter(Boolean);
    if (words.length === 0) return [];
    return entries
      .map(function (entry, position) {
        var all = words.map(function (word) { return distance(word, entry); });
        var worst = all.indexOf(-1) >= 0 ? -1 : Math.max.apply(null, all);
        return { entry: entry, worst: worst, position: position };
      })
      .filter(function (f) { return f.worst >= 0; })
      .sort(function (a, b) {
        return a.worst - b.worst || a.entry[0].length - b.entry[0].length || a.position - b.position;
      })
      .slice(0, most)
      .map(function (f) { return f.entry; });
  }

  // ---------------------------------------------------------------------------
  // Showing

  function make(tag, attributes, text) {
    var node = document.createElement(tag);
    for (var name in attributes) node.setAttribute(name, attributes[name]);
    if (text) node.appendChild(document.createTextNode(text));
    return node;
  }

  function line(entry) {
    var item = make('li', {});
    var link = make('a', { href: entry[1] });
    link.appendChild(make('b', {}, entry[0]));
    link.appendChild(make('span', {}, ' ' + (entry[3] || entry[2])));
    item.appendChild(link);
    return item;
  }

  function install(place) {
    var box = make('input', { id: 'searchbox', 'class': 'searchbox', type: 'search',
                              placeholder: 'search', autocomplete: 'off',
                              'aria-label': 'Search the manual',
                              title: 'A name, or words of what it does' });
    var list = make('ol', { id: 'found' });
    var entries = null, chosen = 0;

    function show() {
      if (entries === null) return;
      var text = box.value.trim(), found = find(text, entries);
      list.textContent = '';
      found.forEach(function (entry) { list.appendChild(line(entry)); });
      if (text && found.length === 0) {
        list.appendChild(make('li', { 'class': 'nothing' }, 'nothing found'));
      }
      list.className = text ? 'shown' : '';
      choose(0);
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
      if (entries !== null || document.getElementById('search-index')) return;
      window.mechanicsManual = function (all) { entries = all; show(); };
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
