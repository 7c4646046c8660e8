// A table of numbers as text, as instruments and spreadsheets of any country write it: comma, semicolon or tab between the
// cells, decimal point or comma, a byte order mark, any line ends, comments, and a row of units below the heading.

/** What the service takes in one request of a track whose answer comes in columns. */
const MOST_ROWS = 100_000;
const SEPARATORS = ["\t", ";", ","];
const SEPARATOR_NAMES = { "\t": "tab", ";": "semicolon", ",": "comma" };
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
const WITH_COMMA = /^[+-]?(\d+,\d*|,\d+)(e[+-]?\d+)?$/i;
/** What spreadsheets write into a cell that has no value, which in the first column is no comment. */
const SHEET_ERROR = /^#(N\/A|DIV\/0!|VALUE!|REF!|NAME\?|NUM!|NULL!)/;
const NOTHING = /^(nan|n\/?a|null|none|[-–—])?$/i;

/** What is wrong with a table, and where. */
export class TableFault extends Error {
  constructor(line, text) {
    super(line === null ? text : `Line ${line}: ${text}`);
    this.line = line;
  }
}

/** The cells of one line; a quoted cell may hold the separator. */
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

const plain = (cell) => cell.replace("\u2212", "-");
const isEmpty = (cell) => NOTHING.test(cell);
const isNumber = (cell) => NUMBER.test(plain(cell)) || WITH_COMMA.test(plain(cell));

/** Commas are decimal where cells have them and no cell has a point; a table with both is not guessed about. */
function decimalOf(rows) {
  const cells = rows.flatMap(({ cells }) => cells).map(plain);
  const has = (pattern, sign) => cells.some((cell) => pattern.test(cell) && cell.includes(sign));
  return has(WITH_COMMA, ",") && !has(NUMBER, ".") ? "," : ".";
}

/**
 * `columns`: [{ heading, unit, cells, texts }] where a cell stands as in the file and a text is a number in the notation of programs, or null where the cell is empty;
 * `faults`: [{ line, column, text, isOdd }] cells that are neither, by the index of their column, odd where the column's first cell says
 * that the form is right; `lines`: line of each row in the file.
 */
export function parseTable(text) {
  const lines = text.replace(/^\uFEFF/, "").split(/\r\n|\n|\r/)
    .map((line, index) => ({ line, number: index + 1 }))
    .filter(({ line }) => line.trim() && !(line.startsWith("#") && !SHEET_ERROR.test(line)));
  if (!lines.length) throw new TableFault(null, "The table is empty.");
  const separator = SEPARATORS.find((each) => lines[0].line.includes(each)) ?? ",";
  const rows = lines.map(({ line, number }) => ({ number, cells: cellsOf(line, separator, number) }));

  const isHeading = rows[0].cells.some((cell) => !isNumber(cell) && !isEmpty(cell));
  const width = rows[0].cells.length;
  const headings = isHeading ? rows.shift().cells : Array.from({ length: width }, (_, index) => `Column ${index + 1}`);
  const hasUnits = isHeading && rows.length > 1 && !rows[0].cells.some(isNumber) && rows[1].cells.some(isNumber);
  const units = hasUnits ? rows.shift().cells : [];
  if (rows.length > MOST_ROWS) throw new TableFault(rows[MOST_ROWS].number, `the service takes ${MOST_ROWS} rows at most.`);
  if (!rows.length) throw new TableFault(null, "The table has a heading and no rows.");

  const uneven = rows.find(({ cells }) => cells.length !== width);
  if (uneven) {
    const { number, cells } = uneven;
    throw new TableFault(number, `${cells.length} cells where the first line has ${width}, with a ${SEPARATOR_NAMES[separator]} between cells.`);
  }
  const decimal = decimalOf(rows);
  const faults = [];
  const columns = headings.map((heading, column) => ({
    heading,
    unit: units[column] ?? "",
    cells: rows.map(({ cells }) => cells[column]),
    texts: rows.map(({ cells, number }, row) => {
      const cell = plain(cells[column]);
      if (isEmpty(cell)) return null;
      const pointed = decimal === "," ? cell.replace(",", ".") : cell;
      if (NUMBER.test(pointed)) return pointed;
      const advice = isNumber(cell) ? "has a decimal comma where other cells have a decimal point" : "is no number";
      faults.push({ line: number, column, isOdd: row > 0 && !isNumber(cell), text: `Line ${number}, column ${column + 1} (${heading}): “${cells[column]}” ${advice}.` });
      return null;
    }),
  }));
  return { columns, faults, lines: rows.map(({ number }) => number), separator: SEPARATOR_NAMES[separator], decimal: decimal === "," ? "comma" : "point" };
}
