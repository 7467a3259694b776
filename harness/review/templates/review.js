'use strict';
// The keys, and the choice of lines. Without this script everything can still be done.
document.addEventListener('DOMContentLoaded', () => {
  const byKey = (key) => [...document.querySelectorAll('[data-key]')]
    .find((element) => element.dataset.key.split(' ').includes(key));
  const keys = document.getElementById('keys');
  const lines = document.querySelector('#reading [name="lines"]');
  const none = document.querySelector('#reading [name="none"]');
  const rows = [...document.querySelectorAll('#printout pre > span')];

  // Which lines the field of lines names, if it names whole lines.
  const range = () => {
    const found = /^(\d+)(?:-(\d+))?(?::.*)?$/.exec(lines.value.trim());
    if (!found) return null;
    const first = Number(found[1]);
    return [first, found[2] ? Number(found[2]) : first];
  };
  const scrollTo = (number) => {
    const row = rows[number - 1];
    if (row) row.parentElement.scrollTop = row.offsetTop - row.parentElement.clientHeight / 3;
  };
  const show = (scroll) => {
    const chosen = range();
    rows.forEach((row, i) => {
      const number = i + 1;
      row.classList.toggle('chosen', chosen !== null && chosen[0] <= number && number <= chosen[1]);
    });
    if (scroll && chosen) scrollTo(chosen[0]);
  };
  const choose = (first, last) => {
    const low = Math.max(1, Math.min(first, last));
    const high = Math.min(rows.length, Math.max(first, last));
    lines.value = low === high ? String(low) : low + '-' + high;
    none.checked = false;
    show(true);
  };
  if (lines) {
    lines.addEventListener('input', () => show(true));
    lines.addEventListener('keydown', (event) => {
      if (event.key !== 'ArrowUp' && event.key !== 'ArrowDown') return;
      event.preventDefault();
      const [first, last] = range() || [0, 0];
      const step = event.key === 'ArrowDown' ? 1 : -1;
      if (event.shiftKey) {
        choose(first, Math.max(first, last + step));
      } else {
        choose(first + step, first + step);
      }
    });
    let begun = 0;
    rows.forEach((row, i) => row.addEventListener('click', (event) => {
      const number = i + 1;
      if (!event.shiftKey || begun === 0) begun = number;
      choose(begun, number);
    }));
    show(true);
  }
  // The printout and the source show the lines of the chosen item.
  const items = [...document.querySelectorAll('[data-item]')];
  const abouts = [...document.querySelectorAll('.decide select[name="about"]')];
  const showItem = (value) => {
    const item = items.find((row) => row.dataset.item === value);
    if (item && item.dataset.line) scrollTo(Number(item.dataset.line));
    const computing = item && item.dataset.source
      ? item.dataset.source.split(' ').map((line) => document.getElementById('source-' + line)).filter(Boolean) : [];
    document.querySelectorAll('[id^="source-"].chosen').forEach((row) => row.classList.remove('chosen'));
    computing.forEach((row) => row.classList.add('chosen'));
    if (computing.length === 0) return;
    const pane = computing[0].parentElement;
    const printing = document.getElementById('source-' + item.dataset.printing);
    const all = printing.offsetTop - computing[0].offsetTop + printing.offsetHeight;
    const shown = 0 <= all && all < pane.clientHeight ? computing[0] : printing;
    pane.scrollTop = shown.offsetTop - Math.max(0, pane.clientHeight - Math.abs(all)) / 3;
  };
  if (abouts.length > 0) showItem(abouts[0].value);
  if (lines && range()) show(true);
  abouts.forEach((select) => select.addEventListener('change', () => showItem(select.value)));
  // An item of the table is the one that the forms are about.
  items.forEach((row) => row.addEventListener('click', () => {
    const value = row.dataset.item;
    abouts.filter((select) => [...select.options].some((option) => option.value === value))
      .forEach((select) => { select.value = value; });
    showItem(value);
  }));
  const fields = { o: '#points [name="points"]', r: '#reading [name="lines"]', c: '#comment [name="text"]' };
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || keys.open) return;
    const field = event.target.closest('input, select, textarea');
    if (field) {
      if (event.key === 'Escape') field.blur();
      if (field.type !== 'checkbox') return;
    }
    const target = fields[event.key] ? document.querySelector(fields[event.key]) : null;
    const pressed = event.key === '?' ? keys : byKey(event.key);
    if (target) {
      target.focus();
      if (target.select) target.select();
      target.scrollIntoView({ block: 'nearest' });
    } else if (pressed === keys) {
      keys.showModal();
    } else if (pressed) {
      pressed.click();
    } else {
      return;
    }
    event.preventDefault();
  });
  document.querySelectorAll('[data-key="?"]').forEach((button) => button.addEventListener('click', () => keys.showModal()));

  // Names and outcomes that hold what was typed.
  const search = document.getElementById('search');
  if (search) {
    search.addEventListener('input', () => document.querySelectorAll('table.students tbody tr').forEach((row) => {
      row.hidden = !row.textContent.toLowerCase().includes(search.value.toLowerCase());
    }));
  }
  document.querySelectorAll('time').forEach((time) => {
    time.textContent = new Date(time.dateTime).toLocaleString();
  });

  // A second press must not send a decision twice.
  document.querySelectorAll('form[method="post"]').forEach((form) => form.addEventListener('submit', (event) => {
    if (form.dataset.sent) event.preventDefault();
    form.dataset.sent = '1';
  }));
  window.addEventListener('pageshow', () => document.querySelectorAll('form').forEach((form) => delete form.dataset.sent));
});
