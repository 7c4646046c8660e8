// What a chart is given to draw.

/** @import { Cell } from "../numbers/columns.js" */

/** @typedef {[number, number]} Domain */

/**
 * @typedef {object} XAxis
 * @property {readonly number[]} values the x of every point of the curves
 * @property {Domain} domain
 * @property {string} label
 * @property {string} name in the legend
 * @property {string} spoken for screen readers
 * @property {(value: number) => string} format
 */

/**
 * @typedef {object} YAxis
 * @property {string} unit
 * @property {{ min?: number, max?: number }} [limits] cut the axis where a curve runs away
 * @property {string} [missing] what a null means
 * @property {(value: number) => string} format
 */

/** @typedef {{ key: string, name: string, values: readonly Cell[] }} Curve the style sheet has a colour and dashes for the key */
/** @typedef {{ key: string, at: number, label: string }} Mark a vertical line */
/** @typedef {{ key: string, at: number, value: Cell }} Dot a single point of the curve with the same key */
/** @typedef {{ key: string, from: number, to: number }} Band a stretch of x */
/** @typedef {{ at: number, value: number }} Point */

/**
 * Measured points.
 * @typedef {object} Points
 * @property {string} key
 * @property {string} name
 * @property {string} reading in the legend
 * @property {readonly Point[]} points
 * @property {boolean} [isListed] in the legend; true where it is absent
 */

/**
 * @typedef {object} ChartSpec
 * @property {string} label what the chart shows, for screen readers
 * @property {XAxis} x
 * @property {YAxis} y
 * @property {Curve[]} curves
 * @property {Mark[]} [marks]
 * @property {Dot[]} [dots]
 * @property {Points | null} [measured]
 * @property {Band[]} [bands]
 * @property {string[]} [basis] what the curves rest on, for the legend
 * @property {number | null} rest the x that the legend reads while there is no cursor
 */

export {};
