// A table of numbers as text, as instruments and spreadsheets of any country write it: comma, semicolon or tab between the
// cells, decimal point or comma, a byte order mark, any line ends, comments, and a row of units below the heading.

import { NUMBER, WITH_DECIMAL_COMMA, withPlainMinus } from "../numbers/plain.js";

/**
 * @typedef {object} TableColumn
 * @property {string} heading
 * @property {string} unit from the row of units, or empty
 * @property {string[]} cells as in the file
 * @property {(string | null)[]} texts numbers in the notation of programs, null where the cell is empty or wrong
 */

/**
 * A cell that is neither a number nor empty. It is odd where the first cell of the column shows that the format is right.
 * @typedef {{ line: number, column: number, text: string, isOdd: boolean }} WrongCell
 */

/**
 * @typedef {object} Table
 * @property {TableColumn[]} columns
 * @property {WrongCell[]} faults
 * @property {number[]} lines line of each row in the file
 * @property {string} separator in words
 * @property {string} decimal in words
 */

/** @typedef {{ number: number, cells: string[] }} Row */

/** What the service takes in one request for a track that is answered in columns. */
const MOST_ROWS = 100_000;
/**
 * In the order in which they are tried.
 * @type {Record<string, string>}
 */
const SEPARATOR_NAMES = { "\t": "tab", ";": "semicolon", ",": "comma" };
/** What spreadsheets write into a cell without a value. In the first column it looks like a comment. */
const SHEET_ERROR = /^#(N\/A|DIV\/0!|VALUE!|REF!|NAME\?|NUM!|NULL!)/;
const NOTHING = /^(nan|n\/?a|null|none|[-–—])?$/i;

/** What is wrong with a table, and where. */
export class TableFault extends Error {
  /**
   * @param {number | null} line
   * @param {string} text
   */
  constructor(line, text) {
    super(line === null ? text : `Line ${line}: ${text}`);
    this.line = line;
  }
}

/**
 * The cells of one line. A quoted cell may have the separator in it.
 * @param {string} line
 * @param {string} separator
 * @param {number} number of the line
 */
function cellsOf(line, separator, number) {
  const cells = [];
  let cell = "";
  let isQuoted = false;
  for (let index = 0; index < line.length; index += 1) {
    const character = line[index];
    if (isQuoted && character === '"' && line[index + 1] === '"') {
      cell += '"';
      index += 1;
    } else if (character === '"') {
      isQuoted = !isQuoted;
    } else if (character === separator && !isQuoted) {
      cells.push(cell.trim());
      cell = "";
    } else {
      cell += character;
    }
  }
  if (isQuoted) throw new TableFault(number, "a quotation mark is not closed.");
  return [...cells, cell.trim()];
}

/** @param {string} cell */
const isEmpty = (cell) => NOTHING.test(cell);

/** @param {string} cell */
const isNumber = (cell) => NUMBER.test(withPlainMinus(cell)) || WITH_DECIMAL_COMMA.test(withPlainMinus(cell));

/**
 * Commas are decimal where cells have them and no cell has a point. A table with both is not guessed at.
 * @param {Row[]} rows
 */
function hasDecimalCommas(rows) {
  const cells = rows.flatMap(({ cells: each }) => each).map(withPlainMinus);
  return cells.some((cell) => WITH_DECIMAL_COMMA.test(cell)) && !cells.some((cell) => NUMBER.test(cell) && cell.includes("."));
}

/**
 * The lines that are no comments, in cells.
 * @param {string} text
 */
function rowsOf(text) {
  const lines = text.replace(/^\uFEFF/, "").split(/\r\n|\n|\r/)
    .map((line, index) => ({ line, number: index + 1 }))
    .filter(({ line }) => line.trim() && !(line.startsWith("#") && !SHEET_ERROR.test(line)));
  if (!lines.length) throw new TableFault(null, "The table is empty.");
  const separator = Object.keys(SEPARATOR_NAMES).find((each) => lines[0].line.includes(each)) ?? ",";
  return { separator: SEPARATOR_NAMES[separator], rows: lines.map(({ line, number }) => ({ number, cells: cellsOf(line, separator, number) })) };
}

/**
 * @param {Row[]} rows
 * @returns {{ headings: string[], units: string[], data: Row[] }}
 */
function withoutHead(rows) {
  const [{ cells: first }, ...others] = rows;
  const isHeading = first.some((cell) => !isNumber(cell) && !isEmpty(cell));
  if (!isHeading) return { headings: first.map((_, index) => `Column ${index + 1}`), units: [], data: rows };
  const hasUnits = others.length > 1 && !others[0].cells.some(isNumber) && others[1].cells.some(isNumber);
  return hasUnits ? { headings: first, units: others[0].cells, data: others.slice(1) } : { headings: first, units: [], data: others };
}

/**
 * @param {Row[]} data
 * @param {number} width
 * @param {string} separator in words
 */
function assertEven(data, width, separator) {
  if (data.length > MOST_ROWS) throw new TableFault(data[MOST_ROWS].number, `the service takes ${MOST_ROWS} rows at most.`);
  if (!data.length) throw new TableFault(null, "The table has a heading and no rows.");
  const uneven = data.find(({ cells }) => cells.length !== width);
  if (!uneven) return;
  throw new TableFault(uneven.number, `${uneven.cells.length} cells where the first line has ${width}, with a ${separator} between cells.`);
}

/**
 * A cell as a number in the notation of programs, or what is wrong with it; null where it is empty.
 * @param {string} cell
 * @param {boolean} isCommaDecimal
 */
function readCell(cell, isCommaDecimal) {
  const plain = withPlainMinus(cell);
  if (isEmpty(plain)) return null;
  const pointed = isCommaDecimal ? plain.replace(",", ".") : plain;
  if (NUMBER.test(pointed)) return { number: pointed };
  return { wrong: isNumber(plain) ? "has a decimal comma where other cells have a decimal point" : "is not a number" };
}

/**
 * @param {string} text
 * @returns {Table}
 */
export function parseTable(text) {
  const { separator, rows } = rowsOf(text);
  const { headings, units, data } = withoutHead(rows);
  assertEven(data, headings.length, separator);
  const isCommaDecimal = hasDecimalCommas(data);
  /** @type {WrongCell[]} */
  const faults = [];
  const columns = headings.map((heading, column) => ({
    heading,
    unit: units[column] ?? "",
    cells: data.map(({ cells }) => cells[column]),
    texts: data.map(({ cells, number }, row) => {
      const read = readCell(cells[column], isCommaDecimal);
      if (read?.wrong) {
        const where = `Line ${number}, column ${column + 1} (${heading})`;
        faults.push({ line: number, column, isOdd: row > 0 && !isNumber(cells[column]), text: `${where}: “${cells[column]}” ${read.wrong}.` });
      }
      return read?.number ?? null;
    }),
  }));
  return { columns, faults, lines: data.map(({ number }) => number), separator, decimal: isCommaDecimal ? "comma" : "point" };
}
