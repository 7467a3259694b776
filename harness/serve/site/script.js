// Sends the forms without leaving the page, so that the typed text is still there if the server refuses it, and shows a
// program's progress through the queue. The site also works without it: browsers post the forms, and the waiting page
// reloads itself.
'use strict';

const largestSource = 1 << 20;
const sending = new WeakSet();

/** Posts a form and returns the result's address, or the error. */
async function post(form) {
    const answer = await fetch(form.action, {
        method: 'POST', body: new FormData(form), headers: {Accept: 'application/json'}});
    if (answer.status === 429)  // of a proxy, which knows nothing of JSON
        return {error: 'Many programs were sent from your network address. Please send yours again in a minute.'};
    const said = await answer.json();
    return answer.ok ? {result: said.result} : {error: said.error};
}

async function send(form) {
    if (sending.has(form)) return;
    const alert = form.querySelector('[role="alert"]');
    const status = form.querySelector('[role="status"]');
    const button = form.querySelector('button');
    const file = form.querySelector('input[type="file"]');
    alert.textContent = '';
    if (file && file.files[0].size > largestSource) {
        alert.textContent = 'Your file is larger than 1 MiB. Please send only the source, without data or output in it.';
        return;
    }
    sending.add(form);
    status.textContent = 'Sending…';
    // Not `disabled`, which would remove the focus from the button.
    button.setAttribute('aria-disabled', 'true');
    let said;
    try {
        said = await post(form);
    } catch {
        said = {error: 'The page could not be reached, so your program was not checked. Please try again in a moment.'};
    }
    sending.delete(form);
    status.textContent = '';
    button.removeAttribute('aria-disabled');
    if (said.result) {
        location.assign(said.result);
    } else {
        alert.textContent = said.error;
    }
}

/** Shows the program's state until its result is there. */
async function follow(place) {
    let pause = 300;
    for (;;) {
        await new Promise((resolve) => setTimeout(resolve, pause));
        let sentence;
        try {
            const said = await (await fetch(place.dataset.standing)).json();
            if (said.standing !== 'waiting' && said.standing !== 'grading') {
                location.reload();
                return;
            }
            sentence = said.sentence;
            pause = 1000;
        } catch {
            sentence = 'The page can’t be reached just now. Your program is not lost; trying again.';
            pause = Math.min(2 * pause, 10000);
        }
        // Screen readers read out every change of the text, so leave it if it is the same.
        if (place.textContent !== sentence) place.textContent = sentence;
    }
}

for (const form of document.querySelectorAll('form')) {
    form.addEventListener('submit', (event) => {
        event.preventDefault();
        send(form);
    });
}
const standing = document.getElementById('standing');
if (standing) follow(standing);
