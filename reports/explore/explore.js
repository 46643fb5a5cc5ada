// Makes the figures of a report explorable: curves with hover values, zoom and
// a choice of axes, maps with a load slider, downloads, dark mode. The page is
// complete without it; each printed figure is replaced when it comes into view.
// Curves are drawn by Chart.js, which the page contains as well. The data of a
// figure is described in explore_data.cpp and packed.hpp.
'use strict';
(() => {
  const root = document.documentElement;
  const style = name => getComputedStyle(root).getPropertyValue(name).trim();

  // ---------------------------------------------------------------- elements
  function element(tag, properties = {}, ...children) {
    const made = Object.assign(document.createElement(tag), properties);
    made.append(...children);
    return made;
  }

  function button(text, title, act) {
    const made = element('button', {type: 'button', textContent: text, title});
    made.addEventListener('click', act);
    return made;
  }

  function download(name, blob) {
    const link = element('a', {download: name, href: URL.createObjectURL(blob)});
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  // -------------------------------------------------------------------- data
  async function unpacked(text) {
    const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }

  // The steps of a map: differences from what the neighbours to the left and
  // above suggest, lower bytes before upper bytes (packed.hpp).
  async function stepsOf(map, columns) {
    const bytes = await unpacked(map.data);
    const count = bytes.length / 2;
    const steps = new Int16Array(count);
    for (let i = 0; i < count; ++i) {
      const code = bytes[i] + 256 * bytes[count + i];
      const difference = code % 2 === 0 ? code / 2 : -(code + 1) / 2;
      const [hasLeft, hasUp] = [i % columns !== 0, i >= columns];
      steps[i] = difference + (hasLeft ? steps[i - 1] : 0) + (hasUp ? steps[i - columns] : 0) -
        (hasLeft && hasUp ? steps[i - columns - 1] : 0);
    }
    return steps;
  }

  // Rows of a table whose first column is a quoted text.
  function rowsOf(text) {
    const lines = text.trim().split('\n');
    const rows = lines.slice(1).map(line => {
      const end = line.startsWith('"') ? /^"(?:[^"]|"")*"/.exec(line)[0].length : line.indexOf(',');
      const label = line.slice(0, end).replace(/^"|"$/g, '').replaceAll('""', '"');
      return [label, ...line.slice(end + 1).split(',').map(Number)];
    });
    return {names: lines[0].split(','), rows};
  }

  function numberText(value) {
    if (!Number.isFinite(value)) return '–';
    const size = Math.abs(value);
    if (size !== 0 && (size < 1e-3 || size >= 1e5)) return value.toExponential(3);
    return String(Number(value.toPrecision(5)));
  }

  // Numbers at an axis: short, or with powers of ten such as 5·10⁻⁴, which very
  // large and small numbers always have.
  function tickText(value, withPowers = false) {
    const exponent = Math.log10(Math.abs(value));
    if (value !== 0 && (exponent < -3 || exponent >= 5 || withPowers && (exponent < -1e-9 || exponent >= 1))) {
      const power = Math.floor(exponent + 1e-9);
      const digits = Number((value / 10 ** power).toPrecision(3));
      const raised = [...String(power)].map(c => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(c)]).join('');
      return (digits === 1 ? '' : digits === -1 ? '−' : digits + '·') + '10' + raised;
    }
    return String(Number(value.toPrecision(6))).replace('-', '−');
  }

  // ------------------------------------------------------------------ colours
  const isDark = () => root.dataset.theme === 'dark' ||
      (!root.dataset.theme && matchMedia('(prefers-color-scheme: dark)').matches);

  const channels = color => [1, 3, 5].map(i => parseInt(color.slice(i, i + 2), 16));

  // The colours of methods and loads on a dark background, as distinct there as
  // on a light one.
  const onDark = {
    '#222222' : '#e4e8ec',
    '#0072b2' : '#3f9bea',
    '#d55e00' : '#ff7f32',
    '#009e73' : '#2fd3a2',
    '#cc79a7' : '#e9a3c9',
    '#e69f00' : '#f2c14e',
    '#56b4e9' : '#b5e3ff',
    '#35102b' : '#f07fb8'
  };

  // Others that are too dark are mixed with white.
  function lineColor(color) {
    if (!/^#[0-9a-f]{6}$/i.test(color)) return style('--ink');
    if (!isDark())
      return color;
    const named = onDark[color.toLowerCase()];
    if (named)
      return named;
    const rgb = channels(color);
    const light = (0.3 * rgb[0] + 0.59 * rgb[1] + 0.11 * rgb[2]) / 255;
    if (light > 0.45)
      return color;
    const share = (0.45 - light) / (1 - light);
    return `rgb(${rgb.map(c => Math.round(c + share * (255 - c))).join(',')})`;
  }

  const palettes = {
    pressure: [[0, '#ffffff'], [0.02, '#fdf2d0'], [0.25, '#f6b65a'], [0.5, '#dd6137'], [0.75, '#98253f'], [1, '#35102b']],
    gap: [[0, '#08203a'], [0.25, '#1f5a8c'], [0.5, '#5b9fc7'], [0.75, '#b5d7e8'], [1, '#f7fbfd']],
    height: [[0, '#1f3b66'], [0.25, '#6f93bd'], [0.5, '#f2efe8'], [0.75, '#cf8a63'], [1, '#7a2a1d']],
    contact: [[0, '#ffffff'], [0.001, '#98253f'], [1, '#98253f']],
  };

  function paletteColor(name, share) {
    const stops = palettes[name];
    const next = Math.max(1, stops.findIndex(stop => stop[0] >= share));
    const [low, high] = [stops[next - 1], stops[next]];
    const part = Math.min(1, Math.max(0, (share - low[0]) / (high[0] - low[0])));
    const [from, to] = [channels(low[1]), channels(high[1])];
    return from.map((c, i) => Math.round(c + part * (to[i] - c)));
  }

  // -------------------------------------------------------------------- zoom
  // Calls zoom(x0, y0, x1, y1) [CSS pixels of the canvas] after a rectangle was
  // dragged, and reset() after a double click. `drawn` shows the rectangle.
  function allowZoom(canvas, zoom, reset, drawn) {
    let start = null;
    canvas.addEventListener('pointerdown', event => {
      if (event.pointerType === 'touch' || event.button !== 0) return; // touch scrolls
      start = [event.offsetX, event.offsetY];
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener('pointermove', event => {
      if (start) drawn([...start, event.offsetX, event.offsetY]);
    });
    canvas.addEventListener('pointerup', event => {
      if (!start) return;
      const [x, y] = start;
      start = null;
      drawn(null);
      if (Math.abs(event.offsetX - x) > 6 && Math.abs(event.offsetY - y) > 6)
        zoom(Math.min(x, event.offsetX), Math.min(y, event.offsetY), Math.max(x, event.offsetX), Math.max(y, event.offsetY));
    });
    canvas.addEventListener('dblclick', reset);
  }

  // A dashed line over the whole height, with its name beside it.
  function drawLine(context, x, area, label) {
    context.save();
    context.globalAlpha = 1;
    context.setLineDash([3, 3]);
    context.beginPath();
    context.moveTo(x, area.top);
    context.lineTo(x, area.bottom);
    context.stroke();
    context.translate(x - 4, area.bottom - 6);
    context.rotate(-Math.PI / 2);
    context.font = '11px sans-serif';
    context.fillText(label, 0, 0);
    context.restore();
  }

  function drawRectangle(context, box) {
    if (!box) return;
    context.save();
    context.strokeStyle = context.fillStyle = '#0072B2';
    context.strokeRect(box[0], box[1], box[2] - box[0], box[3] - box[1]);
    context.globalAlpha = 0.1;
    context.fillRect(box[0], box[1], box[2] - box[0], box[3] - box[1]);
    context.restore();
  }

  // ------------------------------------------------------------------- curves
  // Gnuplot's numbers of markers; those in `filled` are the ones before, filled.
  const markers = {1: 'cross', 2: 'crossRot', 4: 'rect', 6: 'circle', 8: 'triangle', 10: 'triangle', 12: 'rectRot'};
  const filled = [5, 7, 9, 11, 13];

  // The points of a curve, from the rows of the table that belong to it.
  function pointsOf(curve, panel, table) {
    const ofInterval = curve.xInterval ? curve.xFactor : curve.factor;
    const points =
        table.rows.filter(row => row[1] === curve.index)
            .map(
                row => ({
                  x : curve.xFactor * row[curve.x],
                  y : curve.area ? NaN
                                 : curve.factor *
                                       row[curve.y], // an area has limits only
                  low : curve.low === undefined ? NaN
                                                : ofInterval * row[curve.low],
                  high : curve.low === undefined ? NaN
                                                 : ofInterval * row[curve.high],
                  name : row[0],
                }));
    return curve.area ? points.filter(point => Number.isFinite(point.low) &&
                                               Number.isFinite(point.high))
                      : points;
  }

  // Points of a line without data, over the range of the others.
  function straightLine(curve, panel, others) {
    const all = others.flat().map(point => point.x).filter(Number.isFinite);
    const low = panel.x.low ?? Math.min(...all);
    const high = panel.x.high ?? Math.max(...all);
    return Array.from({length: 101}, (_, i) => {
      const x = panel.x.log && low > 0 ? low * (high / low) ** (i / 100) : low + (high - low) * i / 100;
      return {x, y: curve.intercept + curve.slope * x, low: NaN, high: NaN, name: ''};
    });
  }

  // Places of grid lines on a logarithmic axis: with the digits 1 to 9 over up
  // to two decades, only powers of ten over more, at most about eight of them.
  function logTicks(low, high) {
    const [first, last] = [Math.floor(Math.log10(low)), Math.ceil(Math.log10(high))];
    const step = Math.max(1, Math.ceil((last - first) / 8));
    const digits = Math.log10(high / low) <= 2 ? [1, 2, 3, 4, 5, 6, 7, 8, 9] : [1];
    const ticks = [];
    for (let power = Math.ceil(first / step) * step; power <= last; power += step)
      for (const digit of digits) ticks.push(Number(`${digit}e${power}`));
    return ticks.filter(value => value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9));
  }

  // Of the digits, 1 has a text everywhere, 2 and 5 over up to a decade and a
  // half, all of them over less than half a decade.
  function hasText(value, {min, max}) {
    const digit = Math.round(value / 10 ** Math.floor(Math.log10(value) + 1e-9));
    const decades = Math.log10(max / min);
    return digit === 1 || (digit === 2 || digit === 5) && decades < 1.5 || decades < 0.5;
  }

  // "u [nm]" and 3.2 as "u = 3.2 nm".
  function valueWords(label, value) {
    const [, name, unit] =
        /^(.*?)\s*\[([^\]]*)\]$/.exec(label) ?? [ null, label, '' ];
    return `${name || 'x'} = ${numberText(value)}${unit ? ' ' + unit : ''}`;
  }

  class CurvePanel {
    constructor(panel, table, place) {
      this.table = table;
      this.setPanel(panel);
      this.log = {x: panel.x.log, y: panel.y.log};
      this.canvas = element('canvas', {tabIndex: 0});
      this.canvas.setAttribute('role', 'img');
      this.canvas.setAttribute('aria-label', `${panel.y.label} against ${panel.x.label}: arrow keys show the values of a curve, space hides it, plus and minus zoom, 0 resets`);
      // A legend of two rows leaves too little height for the label of y.
      const isTall = panel.curves.filter(curve => curve.label).length > 3;
      place.append(element('div', {className: isTall ? 'canvas tall' : 'canvas'}, this.canvas));
      this.chart = new Chart(this.canvas, this.configuration());
      this.showPoints();
      this.canvas.addEventListener('keydown', event => this.press(event));
      this.canvas.addEventListener('blur', () => this.showTip([]));
      allowZoom(this.canvas, (...box) => this.zoom(box), () => this.reset(), box => {
        this.box = box;
        this.chart.draw();
      });
    }

    // Takes a panel with the same curves, in its units.
    setPanel(panel) {
      this.panel = panel;
      const data = panel.curves.map(
          curve => curve.x === undefined ? null
                                         : pointsOf(curve, panel, this.table));
      this.points =
          data.map((points, i) => points ?? straightLine(panel.curves[i], panel,
                                                         data.filter(Boolean)));
    }

    // True for curves with data, whose values can be shown.
    hasValues(i) { return this.panel.curves[i].x !== undefined && !this.panel.curves[i].area; }

    // A logarithmic axis shows positive values only.
    canBeLog(axis) {
      return this.points.some((points, i) => this.panel.curves[i].x !== undefined && points.some(point => point[axis] > 0));
    }

    dataset(curve, i) {
      const color = lineColor(curve.color);
      const isFilled = filled.includes(curve.marker);
      const radius = 3.8 * (curve.size ?? 1);
      return {
        label : curve.label,
        data : [],
        showLine : curve.line,
        stepped : curve.steps ? 'before' : false,
        borderColor : color,
        backgroundColor : 'transparent',
        pointBorderColor : color,
        borderWidth : curve.markers && !curve.line ? 1.3 : curve.width,
        borderDash : curve.dash === 1   ? []
                     : curve.dash === 2 ? [ 6, 4 ]
                                        : [ 2, 3 ],
        pointBackgroundColor : isFilled ? color : 'transparent',
        pointStyle :
            curve.markers
                ? markers[isFilled ? curve.marker - 1 : curve.marker] ??
                      'circle'
            : curve.area ? 'rect'
                         : 'line',
        pointRadius : curve.markers ? radius : 0,
        clip : 6,
        pointBorderWidth : 1.3,
        pointHoverRadius : this.hasValues(i) ? radius + 1.5 : 0,
        pointHoverBorderWidth : 2,
        yAxisID : curve.second ? 'second' : 'y',
        order : -i, // later ones on top, as on paper
      };
    }

    // The ends of the intervals on an axis, so that its range holds them.
    intervalEnds(name, log) {
      const ends = this.panel.curves.flatMap((curve, i) => {
        const hasInterval = curve.low !== undefined && name === (curve.xInterval ? 'x' : curve.second ? 'second' : 'y');
        return hasInterval ? this.points[i].flatMap(point => [point.low, point.high]) : [];
      }).filter(end => Number.isFinite(end) && (!log || end > 0));
      return ends.length > 0 ? {suggestedMin: Math.min(...ends), suggestedMax: Math.max(...ends)} : {};
    }

    axis(axis, name, log) {
      const limit = value => log && !(value > 0) ? undefined : value;
      const named = new Map(axis.ticks ?? []);
      const build = scale => {
        if (named.size > 0) scale.ticks = [...named.keys()].map(value => ({value}));
        else if (log) scale.ticks = logTicks(scale.min, scale.max).map(value => ({value}));
      };
      return {
        type: log ? 'logarithmic' : 'linear', axis: name === 'x' ? 'x' : 'y',
        position: name === 'second' ? 'right' : name === 'x' ? 'bottom' : 'left',
        min: limit(axis.low), max: limit(axis.high), ...this.intervalEnds(name, log),
        title: {display: true, text: axis.label, color: style('--ink')},
        grid: {color: style('--line'), drawOnChartArea: name !== 'second'},
        afterBuildTicks: build,
        ticks: {
          color: style('--soft'), maxRotation: named.size > 0 ? 50 : 0, autoSkip: !log && named.size === 0, autoSkipPadding: 12, includeBounds: false,
          callback(value) {
            const hasPowers = log && (this.min < 1e-3 || this.max >= 1e5);
            return named.get(value) ?? (log && !hasText(value, this) ? '' : tickText(value, hasPowers));
          },
        },
      };
    }

    scales() {
      const scales = {x: this.axis(this.panel.x, 'x', this.log.x), y: this.axis(this.panel.y, 'y', this.log.y)};
      if (this.panel.second) scales.second = this.axis(this.panel.second, 'second', this.panel.second.log);
      return scales;
    }

    configuration() {
      const panel = this.panel;
      const lines = item => {
        const point = item.raw;
        const curve = this.panel.curves[item.datasetIndex];
        const yLabel = (curve.second ? this.panel.second : this.panel.y).label;
        const interval = point.high > point.low ? ` (${numberText(point.low)} to ${numberText(point.high)})` : '';
        return `${item.dataset.label || point.name}: ${
                   valueWords(this.panel.x.label,
                              point.x)}${curve.xInterval ? interval : ''}, ` +
               `${valueWords(yLabel, point.y)}${
                   curve.xInterval ? '' : interval}`;
      };
      return {
        type : 'scatter',
        data :
            {datasets : panel.curves.map((curve, i) => this.dataset(curve, i))},
        options : {
          animation : false,
          maintainAspectRatio : false,
          // Not `parsing: false`, which takes a path that comes back for one
          // whose ends are its extremes.
          scales : this.scales(),
          interaction : {mode : 'nearest', intersect : false},
          plugins : {
            legend : {
              position : 'bottom',
              onClick : (_, item) => this.toggle(item.datasetIndex),
              labels : {
                color : style('--ink'),
                usePointStyle : true,
                boxHeight : 7,
                filter : item => item.text !== '',
                sort : (a, b) => a.datasetIndex - b.datasetIndex,
                // The legend shows a curve by its point; its lines are short.
                generateLabels : chart =>
                    Chart.defaults.plugins.legend.labels.generateLabels(chart)
                        .map(item => ({
                               ...item,
                               lineDash :
                                   chart.data.datasets[item.datasetIndex]
                                       .borderDash.map(length => length / 2)
                             })),
              },
            },
            tooltip : {
              filter : item => this.hasValues(item.datasetIndex),
              callbacks : {label : lines}
            },
          },
        },
        plugins : [ {
          id : 'asperity',
          beforeDatasetsDraw : chart => this.drawMarks(chart),
          afterDatasetsDraw : chart => this.drawIntervals(chart),
          afterDraw : chart => drawRectangle(chart.ctx, this.box),
        } ],
      };
    }

    // Shows or hides a curve of the legend, with the unnamed curves that belong
    // to it: those of its colour up to the next name of that colour.
    toggle(index) {
      const curves = this.panel.curves;
      const isHidden = this.chart.isDatasetVisible(index);
      this.chart.setDatasetVisibility(index, !isHidden);
      for (let i = index + 1; i < curves.length; ++i) {
        if (curves[i].color !== curves[index].color) continue;
        if (curves[i].label !== '') break;
        this.chart.setDatasetVisibility(i, !isHidden);
      }
      for (let i = 0; i < index; ++i)
        if (curves[i].label === '' && curves[i].color === curves[index].color &&
            !curves.slice(0, index).some(curve => curve.label !== '' && curve.color === curves[i].color))
          this.chart.setDatasetVisibility(i, !isHidden);
      this.chart.update();
    }

    drawMarks(chart) {
      const {ctx, chartArea: area, scales: {x}} = chart;
      ctx.save();
      ctx.beginPath();
      ctx.rect(area.left, area.top, area.width, area.height);
      ctx.clip();
      this.drawBands(chart);
      for (const mark of this.panel.marks) {
        const from = mark.low === null ? area.left : x.getPixelForValue(mark.low);
        const to = mark.high === null ? area.right : x.getPixelForValue(mark.high);
        ctx.fillStyle = ctx.strokeStyle = lineColor(mark.color);
        if (from === to) {
          drawLine(ctx, from, area, mark.label);
          continue;
        }
        ctx.globalAlpha = mark.height < 0 ? 0.1 : 1;
        if (mark.height < 0) ctx.fillRect(from, area.top, to - from, area.height);
        else ctx.fillRect(from, area.bottom - mark.height * area.height - 1.5, to - from, 3);
      }
      ctx.restore();
    }

    // The areas between two columns, as bands.
    areas(chart) {
      return this.panel.curves.flatMap((curve, i) => curve.area && chart.isDatasetVisible(i) ? [{color: curve.color,
        corners: [...this.points[i].map(point => [point.x, point.low]), ...this.points[i].map(point => [point.x, point.high]).reverse()]}] : []);
    }

    // A band is shown as long as a curve of its colour is.
    drawBands(chart) {
      const {ctx, scales: {x, y}} = chart;
      const inside = (value, scale) => scale.type === 'logarithmic' ? Math.max(value, scale.min / 10) : value;
      const bands = this.panel.bands.concat(this.areas(chart));
      for (const band of bands) {
        if (!this.panel.curves.some((curve, i) => curve.color === band.color && chart.isDatasetVisible(i))) continue;
        ctx.fillStyle = lineColor(band.color);
        ctx.globalAlpha = 0.18;
        ctx.beginPath();
        for (const [across, up] of band.corners) ctx.lineTo(x.getPixelForValue(inside(across, x)), y.getPixelForValue(inside(up, y)));
        ctx.fill();
      }
      ctx.globalAlpha = 1;
    }

    drawIntervals(chart) {
      const {ctx, chartArea: area, scales} = chart;
      ctx.save();
      ctx.beginPath();
      ctx.rect(area.left, area.top, area.width, area.height);
      ctx.clip();
      this.panel.curves.forEach((curve, i) => {
        if (curve.low === undefined || curve.area || !chart.isDatasetVisible(i)) return;
        const [x, y] = [scales.x, scales[curve.second ? 'second' : 'y']];
        ctx.strokeStyle = lineColor(curve.color);
        ctx.lineWidth = 1.2;
        ctx.setLineDash(chart.data.datasets[i].borderDash);
        ctx.beginPath();
        for (const point of chart.data.datasets[i].data) {
          const [px, py] = [x.getPixelForValue(point.x), y.getPixelForValue(point.y)];
          const scale = curve.xInterval ? x : y;
          const [low, high] = [scale.getPixelForValue(point.low), scale.getPixelForValue(point.high)];
          if (curve.xInterval) { ctx.moveTo(low, py); ctx.lineTo(high, py); }
          else { ctx.moveTo(px, low); ctx.lineTo(px, high); }
        }
        ctx.stroke();
      });
      ctx.restore();
    }

    showPoints() {
      this.chart.data.datasets.forEach((dataset, i) => {
        dataset.data = this.points[i].filter(point => (!this.log.x || !(point.x <= 0)) && (!this.log.y || !(point.y <= 0)));
      });
      this.chart.options.scales = this.scales();
      this.chart.update();
    }

    setLog(axis, isLog) {
      this.log[axis] = isLog;
      this.showPoints();
    }

    zoom([x0, y0, x1, y1]) {
      for (const scale of Object.values(this.chart.scales)) {
        const [from, to] = scale.axis === 'x' ? [x0, x1] : [y1, y0];
        Object.assign(this.chart.options.scales[scale.id], {min: scale.getValueForPixel(from), max: scale.getValueForPixel(to)});
      }
      this.chart.update();
    }

    reset() {
      this.chart.options.scales = this.scales();
      this.chart.update();
    }

    // Shows the values of these points, given as [{datasetIndex, index}].
    showTip(points) {
      this.chart.setActiveElements(points);
      this.chart.tooltip.setActiveElements(points, {x: 0, y: 0});
      this.chart.update();
    }

    // Left and right move along a curve, up and down to another curve, space
    // hides or shows it, plus and minus zoom around the point, 0 resets.
    press(event) {
      const datasets = this.chart.data.datasets;
      const curves = datasets.map((_, i) => i).filter(i => this.hasValues(i) && datasets[i].data.length > 0);
      if (curves.length === 0 || event.ctrlKey || event.altKey || event.metaKey) return;
      const at = this.at ?? {datasetIndex: curves[0], index: -1};
      const along = {ArrowRight: 1, ArrowLeft: -1}[event.key] ?? 0;
      const across = {ArrowDown: 1, ArrowUp: -1}[event.key] ?? 0;
      const factor = {'+': 0.5, '=': 0.5, '-': 2}[event.key];
      if (along === 0 && across === 0 && !factor && ![' ', '0', 'Escape'].includes(event.key)) return;
      event.preventDefault();
      const next = (curves.indexOf(at.datasetIndex) + across + curves.length) % curves.length;
      const last = datasets[curves[next]].data.length - 1;
      this.at = {datasetIndex: curves[next], index: Math.min(last, Math.max(0, at.index + along))};
      if (event.key === ' ') this.toggle(this.at.datasetIndex);
      if (event.key === '0' || event.key === 'Escape') this.reset();
      if (factor) this.zoomAround(datasets[this.at.datasetIndex].data[this.at.index], factor);
      this.showTip(this.chart.isDatasetVisible(this.at.datasetIndex) ? [this.at] : []);
    }

    // Enlarges (factor below 1) or reduces the part that is shown.
    zoomAround(point, factor) {
      const area = this.chart.chartArea;
      const [x, y] = [this.chart.scales.x.getPixelForValue(point.x), this.chart.scales[this.panel.curves[this.at.datasetIndex].second ? 'second' : 'y'].getPixelForValue(point.y)];
      this.zoom([x + factor * (area.left - x), y + factor * (area.top - y), x + factor * (area.right - x), y + factor * (area.bottom - y)]);
    }

    // Draws with so many pixels per CSS pixel.
    resolve(ratio) {
      this.chart.options.devicePixelRatio = ratio;
      this.chart.resize();
    }

    recolor() {
      this.chart.data.datasets.forEach((dataset, i) => Object.assign(dataset, this.dataset(this.panel.curves[i], i), {data: dataset.data}));
      this.chart.options.plugins.legend.labels.color = style('--ink');
      this.reset();
    }
  }

  // --------------------------------------------------------------------- maps
  class MapView {
    constructor(stack, place) {
      this.stack = stack;
      this.cache = new Map();
      this.quantities = stack.quantities.flatMap(
          (quantity,
           i) => [{...quantity, map : i, factor : 1},
                  ...(quantity.other
                          ? [ {...quantity, ...quantity.other, map : i} ]
                          : [])]);
      this.frame = stack.frames.length - 1;
      this.quantity = 0;
      this.isCommon = false;
      this.canvas = element('canvas', {className: 'map', tabIndex: 0});
      this.canvas.setAttribute('role', 'img');
      this.canvas.setAttribute('aria-label', 'map: arrow keys move the point whose value is shown, plus and minus zoom, 0 resets');
      this.words = element('p', {className: 'note values', textContent: '\u00a0'});
      place.append(this.controls(), element('div', {className: 'map-place'}, this.canvas), this.words);
      this.reset();
      allowZoom(this.canvas, (...box) => this.zoom(box), () => this.reset(), box => this.paint(box));
      this.canvas.addEventListener('pointermove', event => this.hover(event));
      this.canvas.addEventListener('keydown', event => this.press(event));
      new ResizeObserver(() => this.paint()).observe(this.canvas.parentElement);
    }

    controls() {
      const stack = this.stack;
      const bar = element('div', {className: 'controls'});
      if (this.quantities.length > 1) {
        const choice = element('select', {title: 'quantity'}, ...this.quantities.map(({label}, i) => element('option', {value: i, textContent: label})));
        choice.addEventListener('change', () => { this.quantity = Number(choice.value); this.show(); });
        bar.append(choice);
      }
      this.loadText = element('output');
      if (stack.frames.length > 1) {
        this.slider = element('input', {type: 'range', min: 0, max: stack.frames.length - 1, step: 1, title: 'load'});
        this.slider.value = this.frame;
        this.slider.addEventListener('input', () => { this.frame = Number(this.slider.value); this.show(); });
        const common = element('input', {type: 'checkbox'});
        common.addEventListener('change', () => { this.isCommon = common.checked; this.show(); });
        bar.append(element('label', {}, 'load ', this.slider), this.loadText,
          element('label', {title: 'the colours of all loads mean the same values'}, common, ' same colours for all loads'));
      } else {
        bar.append(this.loadText);
      }
      return bar;
    }

    map() { return this.stack.frames[this.frame].maps[this.quantities[this.quantity].map]; }

    // Range of values that the colours cover, as on paper.
    range() {
      const {map, colors, span : least, factor} =
          this.quantities[this.quantity];
      if (colors === 'contact') return [0, 1];
      if (least > 0)
        return [ -least * factor, least * factor ];
      const maps = (this.isCommon ? this.stack.frames : [this.stack.frames[this.frame]]).map(frame => frame.maps[map]);
      const high = factor * Math.max(...maps.map(one => one.shownHigh));
      const span =
          Math.max(high, -factor * Math.min(...maps.map(one => one.shownLow)));
      return colors === 'height' ? [ -span, span ] : [ 0, high ];
    }

    valueAt(i) {
      const step = this.steps[i];
      const {low, high} = this.map();
      if (step > this.stack.steps) return NaN;
      return this.quantities[this.quantity].factor *
             (low + (high - low) * step / this.stack.steps);
    }

    // Unpacks the map that is asked for and paints it.
    async show() {
      const [frame, quantity] = [this.frame, this.quantity];
      const key = `${frame} ${this.quantities[quantity].map}`;
      if (!this.cache.has(key)) this.cache.set(key, stepsOf(this.map(), this.stack.columns));
      const steps = await this.cache.get(key);
      if (frame !== this.frame || quantity !== this.quantity) return; // superseded meanwhile
      this.steps = steps;
      this.loadText.textContent = this.stack.frames[frame].title;
      this.colored = this.colors();
      this.paint();
    }

    colors() {
      const {columns, rows} = this.stack;
      const [low, high] = this.range();
      const {colors} = this.quantities[this.quantity];
      const table = Array.from({length: 512}, (_, i) => paletteColor(colors, i / 511));
      const picture = new ImageData(columns, rows);
      for (let i = 0; i < this.steps.length; ++i) {
        const value = this.valueAt(i);
        const share = high > low ? (value - low) / (high - low) : 0;
        const entry = table[Math.min(511, Math.max(0, Math.round(511 * share)))] ?? [160, 160, 160];
        const at = 4 * ((rows - 1 - Math.floor(i / columns)) * columns + i % columns); // row 0 is lowest
        picture.data.set([...entry, 255], at);
      }
      const canvas = element('canvas', {width: columns, height: rows});
      canvas.getContext('2d').putImageData(picture, 0, 0);
      return canvas;
    }

    // Place of the map on the canvas [CSS pixels].
    layout() {
      const {left, right, lower, upper} = this.stack;
      const width = Math.min(this.canvas.parentElement.clientWidth, 620);
      const margin = {left : 58, right : 96, top : 8, bottom : 42};
      const across = Math.max(50, width - margin.left - margin.right);
      const shape = Math.abs((upper - lower) / (right - left)) * (this.view.high - this.view.low) / (this.view.right - this.view.left);
      const down = Math.min(across * shape, 700);
      return {x: margin.left, y: margin.top, width: across, height: down, all: width, allHeight: down + margin.top + margin.bottom};
    }

    paint(box = null, ratio = devicePixelRatio || 1) {
      if (!this.colored || this.canvas.parentElement.clientWidth === 0) return;
      const place = this.place = this.layout();
      Object.assign(this.canvas, {width: place.all * ratio, height: place.allHeight * ratio});
      Object.assign(this.canvas.style, {width: place.all + 'px', height: place.allHeight + 'px'});
      const context = this.canvas.getContext('2d');
      context.scale(ratio, ratio);
      context.imageSmoothingEnabled = false;
      const {columns, rows} = this.stack;
      const view = this.view;
      context.drawImage(this.colored, view.left * columns, (1 - view.high) * rows, (view.right - view.left) * columns,
        (view.high - view.low) * rows, place.x, place.y, place.width, place.height);
      this.drawAxes(context, place);
      this.drawColors(context, place);
      drawRectangle(context, box);
    }

    edges() {
      const {left, right, lower, upper} = this.stack;
      const view = this.view;
      return {left: left + (right - left) * view.left, right: left + (right - left) * view.right,
        lower: lower + (upper - lower) * view.low, upper: lower + (upper - lower) * view.high};
    }

    drawAxes(context, place) {
      const edges = this.edges();
      context.font = '12px sans-serif';
      context.fillStyle = context.strokeStyle = style('--ink');
      context.strokeRect(place.x, place.y, place.width, place.height);
      context.textAlign = 'center';
      for (const value of roundValues(edges.left, edges.right, place.width / 70)) {
        const x = place.x + place.width * (value - edges.left) / (edges.right - edges.left);
        context.fillRect(x, place.y + place.height, 1, 4);
        context.fillText(tickText(value), x, place.y + place.height + 17);
      }
      context.fillText(this.stack.xLabel, place.x + place.width / 2, place.y + place.height + 35);
      context.textAlign = 'right';
      for (const value of roundValues(edges.lower, edges.upper, place.height / 50)) {
        const y = place.y + place.height * (edges.upper - value) / (edges.upper - edges.lower);
        context.fillRect(place.x - 4, y, 4, 1);
        context.fillText(tickText(value), place.x - 7, y + 4);
      }
      context.save();
      context.translate(12, place.y + place.height / 2);
      context.rotate(-Math.PI / 2);
      context.textAlign = 'center';
      context.fillText(this.stack.yLabel, 0, 0);
      context.restore();
    }

    drawColors(context, place) {
      const {colors} = this.quantities[this.quantity];
      const [low, high] = this.range();
      const x = place.x + place.width + 12;
      for (let i = 0; i < place.height; ++i) {
        context.fillStyle = `rgb(${paletteColor(colors, 1 - i / place.height)})`;
        context.fillRect(x, place.y + i, 14, 1.5);
      }
      context.fillStyle = context.strokeStyle = style('--ink');
      context.strokeRect(x, place.y, 14, place.height);
      context.save();
      context.translate(place.all - 8, place.y + place.height / 2);
      context.rotate(-Math.PI / 2);
      context.textAlign = 'center';
      context.fillText(this.quantities[this.quantity].label, 0, 0);
      context.restore();
      context.textAlign = 'left';
      if (colors === 'contact') return;
      for (const value of roundValues(low, high, place.height / 40))
        context.fillText(tickText(value), x + 19, place.y + place.height * (high - value) / (high - low || 1) + 4);
    }

    // Share of the whole map at a place on the canvas.
    shareAt(x, y) {
      const {place, view} = this;
      return [view.left + (view.right - view.left) * (x - place.x) / place.width,
        view.high - (view.high - view.low) * (y - place.y) / place.height];
    }

    hover(event) {
      if (!this.place || !this.steps) return;
      const [across, up] = this.shareAt(event.offsetX, event.offsetY);
      this.words.textContent = this.wordsAt(across, up);
    }

    // Arrow keys move a point by a fiftieth of what is shown; its value is
    // written below the map.
    press(event) {
      const step = {ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
      const factor = {'+': 0.5, '=': 0.5, '-': 2}[event.key];
      if (!this.place || !this.steps || event.ctrlKey || event.altKey || event.metaKey) return;
      if (!step && !factor && event.key !== '0' && event.key !== 'Escape') return;
      event.preventDefault();
      const {left, right, low, high} = this.view;
      const at = this.at ?? [0.5, 0.5];
      const limited = (value, from, to) => Math.min(to - 1e-9, Math.max(from, value));
      const moved = step ?? [0, 0];
      this.at = [limited(at[0] + moved[0] * (right - left) / 50, left, right), limited(at[1] + moved[1] * (high - low) / 50, low, high)];
      const place = this.place;
      const [x, y] = [place.x + place.width * (this.at[0] - left) / (right - left), place.y + place.height * (high - this.at[1]) / (high - low)];
      if (factor) this.zoom([x + factor * (place.x - x), y + factor * (place.y - y), x + factor * (place.x + place.width - x), y + factor * (place.y + place.height - y)]);
      else if (!step) this.reset();
      else this.paint([x - 4, y - 4, x + 4, y + 4]);
      this.words.textContent = this.wordsAt(...this.at);
    }

    wordsAt(across, up) {
      const {columns, rows, left, right, lower, upper, xLabel, yLabel} = this.stack;
      if (across < this.view.left || across >= this.view.right || up < this.view.low || up >= this.view.high) return '\u00a0';
      const at = Math.floor(up * rows) * columns + Math.floor(across * columns);
      const {label, colors} = this.quantities[this.quantity];
      const share = this.valueAt(at); // of the nodes of a block
      const value = share === 1 ? 'yes' : share ? `${Math.round(100 * share)} %` : 'no';
      return `${valueWords(xLabel, left + (right - left) * across)}, ${
                 valueWords(yLabel, lower + (upper - lower) * up)}; ` +
             (colors === 'contact' ? `${label}: ${value}`
                                   : valueWords(label, share));
    }

    zoom([x0, y0, x1, y1]) {
      const limited = value => Math.min(1, Math.max(0, value));
      const [left, high] = this.shareAt(x0, y0).map(limited);
      const [right, low] = this.shareAt(x1, y1).map(limited);
      if (right - left < 2 / this.stack.columns || high - low < 2 / this.stack.rows) return;
      this.view = {left, right, low, high};
      this.paint();
    }

    reset() {
      this.view = {left: 0, right: 1, low: 0, high: 1};
      this.show();
    }

    recolor() { this.paint(); }

    // Draws with so many pixels per CSS pixel.
    resolve(ratio) { this.paint(null, ratio); }

    csv() {
      const {columns, rows} = this.stack;
      return Array.from({length: rows}, (_, row) => Array.from({length: columns}, (_, column) => Number(this.valueAt(row * columns + column).toPrecision(6))).join(',')).join('\n') + '\n';
    }
  }

  // Round values between two limits, about `count` of them.
  function roundValues(from, to, count) {
    const [low, high] = [Math.min(from, to), Math.max(from, to)];
    const least = (high - low) / Math.max(2, count);
    if (!(least > 0) || !Number.isFinite(least)) return [low];
    const power = 10 ** Math.floor(Math.log10(least));
    const step = power * ([1, 2, 5].find(digit => digit * power >= least) ?? 10);
    const values = [];
    for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) values.push(Number((i * step).toPrecision(12)));
    return values;
  }

  // ------------------------------------------------------------------ figures
  class ExplorableFigure {
    constructor(figure, data) {
      this.figure = figure;
      this.data = data;
      this.parts = [];
    }

    async build() {
      const place = element('div', {className: 'explore'});
      this.table = new TextDecoder().decode(await unpacked(this.data.table));
      this.figure.querySelector('h3').after(place);
      this.figure.classList.add('explored'); // hides the printed figure
      try {
        this.bar = element('div', {className: 'controls'});
        if (this.data.panels) this.buildCurves(place);
        if (this.data.maps) this.parts.push(new MapView(this.data.maps, place));
        this.addDownloads();
        place.append(this.bar);
      } catch (error) {
        place.remove();
        this.figure.classList.remove('explored'); // the printed figure stays
        throw error;
      }
    }

    buildCurves(place) {
      const table = rowsOf(this.table);
      const panels = element('div', {className: 'panels'});
      place.append(panels);
      for (const panel of this.data.panels) this.parts.push(new CurvePanel(panel, table, panels));
      for (const axis of ['x', 'y']) {
        const box = element('input', {type: 'checkbox', checked: this.parts.every(part => part.log[axis])});
        box.disabled = !this.parts.every(part => part.canBeLog(axis));
        box.addEventListener('change', () => this.parts.forEach(part => part.setLog(axis, box.checked)));
        this.bar.append(element('label', {title: `logarithmic ${axis} axis`}, box, ` log ${axis}`));
      }
      if (this.data.panels.some(panel => panel.other))
        this.addUnits();
    }

    // The units of the axes, named by their labels.
    addUnits() {
      const names =
          key => [...new Set(this.data.panels.flatMap(
                      panel => ['x', 'y'].map(
                          axis => (key(panel) ?? panel)[axis].label)))]
                     .join('; ');
      const choice =
          element('select', {title : 'units of the axes', className : 'units'},
                  ...[panel => panel, panel => panel.other].map(
                      (key, i) => element(
                          'option', {value : i, textContent : names(key)})));
      choice.addEventListener('change', () => this.parts.forEach((part, i) => {
        const panel = this.data.panels[i];
        part.setPanel(choice.value === '1' ? panel.other ?? panel : panel);
        part.showPoints();
      }));
      this.bar.append(choice);
    }

    addDownloads() {
      const name = this.data.name;
      this.bar.append(
          button('reset',
                 'show everything; a drag zooms, a double click resets',
                 () => this.parts.forEach(part => part.reset())),
          button('CSV', 'download the numbers',
                 () => download(`${name}.csv`,
                                new Blob([ this.csv() ], {type : 'text/csv'}))),
          button('PNG', 'download what is shown, with 600 pixels per inch',
                 () => this.picture().toBlob(
                     blob => download(`${name}.png`, blob))));
      const printed = this.figure.querySelector('img');
      if (printed)
        this.bar.append(button('SVG', 'download the printed figure', () => download(`${name}.svg`,
          new Blob([decodeURIComponent(printed.src.slice(printed.src.indexOf(',') + 1))], {type: 'image/svg+xml'}))));
    }

    csv() { return this.data.panels ? this.table : this.parts[0].csv(); }

    // All canvases of the figure in one picture, of 96 CSS pixels per inch.
    picture(ratio = 600 / 96) {
      this.parts.forEach(part => part.resolve(ratio));
      const canvases = this.parts.map(part => part.canvas);
      const whole = element('canvas', {width: Math.max(...canvases.map(one => one.width)), height: canvases.reduce((sum, one) => sum + one.height, 0)});
      const context = whole.getContext('2d');
      context.fillStyle = style('--paper');
      context.fillRect(0, 0, whole.width, whole.height);
      let y = 0;
      for (const one of canvases) {
        context.drawImage(one, 0, y);
        y += one.height;
      }
      this.parts.forEach(part => part.resolve(devicePixelRatio || 1));
      return whole;
    }
  }

  // --------------------------------------------------------------------- page
  const figures = new Map();

  // The spots in the tables have the colours of the curves.
  function colorSwatches() {
    for (const swatch of document.querySelectorAll('.swatch')) {
      swatch.dataset.color ??= /#[0-9a-f]{6}/i.exec(swatch.getAttribute('style') ?? '')?.[0] ?? '';
      if (swatch.dataset.color) swatch.style.background = lineColor(swatch.dataset.color);
    }
  }

  function recolor() {
    colorSwatches();
    for (const figure of figures.values()) for (const part of figure.parts) part.recolor();
  }

  function addThemeButton() {
    const theme = button('◐', 'light or dark', () => {
      root.dataset.theme = isDark() ? 'light' : 'dark';
      recolor();
    });
    theme.className = 'theme';
    document.body.prepend(theme);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', recolor);
  }

  function start() {
    addThemeButton();
    colorSwatches();
    const seen = new IntersectionObserver(entries => {
      for (const entry of entries) {
        if (!entry.isIntersecting) continue;
        seen.unobserve(entry.target);
        const figure = figures.get(entry.target);
        figure.build().then(() => { entry.target.dataset.explore = 'ready'; }, error => {
          entry.target.dataset.explore = 'failed';
          console.error(`${figure.data.name}: ${error}`);
        });
      }
    }, {rootMargin: '300px'});
    for (const script of document.querySelectorAll('script[type="application/json"]')) {
      const data = JSON.parse(script.textContent);
      if (data.panels && typeof Chart === 'undefined') continue; // printed figure only
      const figure = script.closest('figure');
      figures.set(figure, new ExplorableFigure(figure, data));
      seen.observe(figure);
    }
    window.asperity = {figures};
  }

  if (typeof DecompressionStream !== 'undefined') start();
})();
