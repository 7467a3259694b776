// The parts of the class report that its tests look at.
/** The ids of the students whose rows are shown. */
export const shownIds = (page) => page.locator('#class tbody tr:not([hidden]) th').allTextContents();
/** The cells of a column, from 1, in the rows that are shown. */
export const column = (page, number) => page.locator(`#class tbody tr:not([hidden]) > :nth-child(${number})`).allTextContents();
export const heading = (page, name) => page.getByRole('columnheader', { name, exact: true });
/** The student's page that is open over the report. */
export const panel = (page) => page.locator('dialog[open]');
