
'use strict';
// Sorting, filtering and the panel of one student. Without this script the page still shows everything. A large class has no
// sheets here, and so no panel: names lead to the students' own pages.
document.documentElement.classList.add('scripted');
document.addEventListener('DOMContentLoaded', () => {
  const byId = (id) => document.getElementById(id);
  document.querySelectorAll('time').forEach((time) => { time.textContent = new Date(time.dateTime).toLocaleString(); });
  const body = byId('class').tBodies[0];
  const rows = [...body.rows];
  const collator = new Intl.Collator(undefined, { numeric: true, sensitivity: 'base' });
  const hasSheets = byId('each') !== null;
  const linkOf = (row) => row.querySelector('a');
  const addressOf = (link) => link.getAttribute('href');
  const articleOf = (row) => byId(addressOf(linkOf(row)).slice(1));
  const shownRows = () => [...body.rows].filter((row) => !row.hidden);

  // Sorting: a button in each heading. Cells without a number come last in both directions.
  const compare = (kind, column, direction) => (a, b) => {
    const x = a.cells[column].textContent;
    const y = b.cells[column].textContent;
    if (kind === 'text') return direction * collator.compare(x, y);
    const p = parseFloat(x);
    const q = parseFloat(y);
    if (isNaN(p) || isNaN(q)) return isNaN(p) - isNaN(q);
    return direction * (p - q);
  };
  const headings = [...byId('class').tHead.rows[0].cells];
  headings.forEach((heading, column) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.append(...heading.childNodes);
    heading.append(button);
    button.addEventListener('click', () => {
      const ascending = heading.getAttribute('aria-sort') !== 'ascending';
      headings.forEach((other) => other.removeAttribute('aria-sort'));
      heading.setAttribute('aria-sort', ascending ? 'ascending' : 'descending');
      body.append(...[...body.rows].sort(compare(heading.dataset.sort, column, ascending ? 1 : -1)));
    });
  });

  // Filtering.
  const words = rows.map((row) => `${row.textContent} ${row.dataset.mistakes ?? ''}`.toLowerCase());
  const pointsColumn = headings.findIndex((heading) => heading.textContent.trim() === 'Points');
  let only = null;  // where the names lead of those who are to be shown; null for all
  const columnOf = (question) => headings.findIndex((heading) => heading.dataset.question === question);
  const filter = () => {
    const find = byId('find').value.trim().toLowerCase();
    const outcome = byId('outcome').value;
    const lost = byId('lost').value === '' ? -1 : columnOf(byId('lost').value);
    const bin = byId('points').selectedOptions[0];
    const hasPoints = (row) => {
      const points = parseFloat(row.cells[pointsColumn].textContent);
      return bin.value === '' || (points >= Number(bin.value) && points < Number(bin.dataset.below));
    };
    let shown = 0;
    rows.forEach((row, i) => {
      const lostThere = lost < 0 || /part|zero/.test(row.cells[lost].className);
      const kept = !byId('review').checked || row.dataset.review;
      const fits = words[i].includes(find) && (outcome === '' || row.dataset.outcome === outcome) && lostThere && kept && hasPoints(row) &&
        (only === null || only.has(addressOf(linkOf(row))));
      row.hidden = !fits;
      if (fits) shown += 1;
    });
    byId('shown').textContent = shown + ' of ' + rows.length + ' shown';
    if (hasSheets && byId('all').getAttribute('aria-pressed') === 'true') showInFull(true);
  };
  // What is clicked above or below the table filters it: a tile, a bar, an outcome, a mistake.
  const setFilter = ({ find = '', outcome = '', points = '', review = false, who = null, words: text = '' }) => {
    byId('find').value = find;
    byId('outcome').value = outcome;
    byId('lost').value = '';
    byId('points').value = points;
    byId('review').checked = review;
    only = who;
    byId('only').hidden = who === null;
    byId('only').textContent = `Only ${text} ✕`;
    filter();
    byId('students').scrollIntoView();
  };
  byId('only').addEventListener('click', () => setFilter({}));
  const onClick = (selector, filterOf) => document.querySelectorAll(selector).forEach((one) => {
    one.addEventListener('click', (event) => {
      event.preventDefault();
      setFilter(filterOf(one));
    });
  });
  onClick('.tiles a', ({ dataset }) => ({ all: {}, review: { review: true } })[dataset.filter] ?? { find: dataset.filter });
  onClick('.outcomes a[data-outcome]', ({ dataset }) => ({ outcome: dataset.outcome }));
  onClick('.distribution a', ({ dataset }) => ({ points: dataset.points }));
  document.querySelectorAll('.mistakes li').forEach((group) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'small';
    button.textContent = 'Show in the table';
    group.querySelector('p').append(' ', button);
    button.addEventListener('click', () => {
      const who = new Set([...group.querySelectorAll('.who a')].map(addressOf));
      const name = group.querySelector('p > strong:not(.count)') ?? group.querySelector('p > code');
      setFilter({ who, words: `those with ${name.textContent}` });
    });
  });
  byId('filter').addEventListener('input', filter);
  byId('filter').addEventListener('submit', (event) => event.preventDefault());
  byId('filter').hidden = false;

  // Shows all students in the table in full, one below the other.
  const showInFull = (on) => {
    byId('all').setAttribute('aria-pressed', String(on));
    byId('each').classList.toggle('shown', on);
    rows.forEach((row) => { articleOf(row).parentElement.open = on && !row.hidden; });
  };

  // Shows one student in a panel: the sheet itself is moved there and back.
  const openPanel = () => {
    const panel = byId('panel');
    let open = null;
    const putBack = () => {
      if (!open) return;
      open.home.append(open.article);
      open = null;
    };
    const show = (article) => {
      putBack();
      open = { article, home: article.parentElement, row: rows.find((row) => articleOf(row) === article) };
      byId('panel-body').append(article);
      panel.setAttribute('aria-labelledby', article.getAttribute('aria-labelledby'));
      const order = shownRows();
      const at = order.indexOf(open.row);
      byId('previous').disabled = at <= 0;
      byId('next').disabled = at < 0 || at === order.length - 1;
      if (!panel.open) panel.showModal();
      panel.scrollTop = 0;
    };
    const step = (by) => {
      const order = shownRows();
      const row = order[order.indexOf(open.row) + by];
      if (row) show(articleOf(row));
    };
    byId('previous').addEventListener('click', () => step(-1));
    byId('next').addEventListener('click', () => step(1));
    byId('close').addEventListener('click', () => panel.close());
    panel.addEventListener('click', (event) => { if (event.target === panel) panel.close(); });
    panel.addEventListener('close', () => {
      const row = open ? open.row : null;
      putBack();
      if (row && !row.hidden) linkOf(row).focus();
    });
    // A line of a printout or a source is folded away until a link leads to it.
    const unfold = (target) => {
      const folded = target && target.closest('details.listed');
      if (folded) folded.open = true;
    };
    document.addEventListener('click', (event) => {
      const link = event.target.closest('a[href^="#s"]');
      if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
      const target = byId(link.hash.slice(1));
      unfold(target);
      if (!target || target.tagName !== 'ARTICLE') return;
      event.preventDefault();
      show(target);
    });
    const linked = location.hash.startsWith('#s') ? byId(location.hash.slice(1)) : null;
    const linkedArticle = linked && linked.closest('article');
    if (linkedArticle) {
      show(linkedArticle);
      unfold(linked);
      if (linked !== linkedArticle) linked.scrollIntoView();
    }
  };
  if (hasSheets) {
    byId('all').addEventListener('click', () => showInFull(byId('all').getAttribute('aria-pressed') !== 'true'));
    openPanel();
  } else {
    // In a tab of its own, because coming back would take as long as opening this page, and the filter would be lost.
    document.addEventListener('click', (event) => {
      const link = event.target.closest('a[href^="feedback/"]');
      if (link) link.target = '_blank';
    });
  }
  filter();
});
