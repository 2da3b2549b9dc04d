-- page.lua - what pandoc does to each page of the book.
--
-- Links lead to the pages of the book, quotes and names of sources to the sources'
-- pages, and pictures stand in the page itself. The environment tells:
--   PAGE     the page, as a path from the root of the project
--   QUOTES   a file with the lines of `weave --list`
--   LINKED   a file to which the sources that this page leads to are added
--   TRI      the program tri, which runs the algorithms that the page shows step by step

local page = os.getenv("PAGE")
local folder = page:match("^(.*/)") or ""
local linked = io.open(os.getenv("LINKED"), "a")

-- The quotes of this page, in their order.
local quotes = {}
for line in io.lines(os.getenv("QUOTES")) do
  local where, path, first, last = line:match("^(%S+) (%S+) (%d+) (%d+)$")
  if where == page then
    table.insert(quotes, {path = path, first = first, last = last})
  end
end
local quoted = 0

local function exists(path)
  local file = io.open(path)
  if file then file:close() end
  return file ~= nil
end

-- a/b/../c -> a/c
local function simplify(path)
  local parts = {}
  for part in path:gmatch("[^/]+") do
    if part == ".." then table.remove(parts)
    elseif part ~= "." then table.insert(parts, part) end
  end
  return table.concat(parts, "/")
end

-- From this page to a file of the book.
local function relative(path)
  return folder:gsub("[^/]+/", "../") .. path
end

-- The file of the book that shows a file of the project.
local function target(path)
  if path:match("%.svg$") or path:match("%.png$") then return path end
  if exists(path .. "/README.md") then path = path .. "/README.md" end
  if path == "README.md" then return "index.html" end
  if path:match("/README%.md$") then return (path:gsub("README%.md$", "index.html")) end
  if path:match("%.md$") then return (path:gsub("%.md$", ".html")) end
  if exists(path) then linked:write(path, "\n") end
  return path .. ".html"
end

function Link(link)
  if link.target:match("^%a+:") or link.target:match("^#") then return nil end
  local path, anchor = link.target:match("^([^#]*)(.*)$")
  link.target = relative(target(simplify(folder .. path))) .. anchor
  return link
end

-- `lib/mesh.h mesh_next` is a link to that file.
function Code(code)
  local path = code.text:match("^%l+/[^ *]+")
  if path and path:match("%.%l+$") and exists(path) then
    return pandoc.Link({code}, relative(target(path)))
  end
end

-- ```math is a formula as well, one whose backslashes GitHub does not take for its own.
function CodeBlock(block)
  if block.classes[1] ~= "math" then return nil end
  return pandoc.Para({pandoc.Math("DisplayMath", block.text)})
end

-- The panels of a picture of lib/svg.c, each as a picture of its own: where there is no
-- room side by side they stand below each other. Nothing is drawn outside the panels; the
-- lines of a panel's caption come before it.
local function panels_of(svg)
  local style, body = svg:match('(<style>.-</style>)%s*<rect class="paper"[^>]*/>(.*)</svg>')
  local panels, columns, widest = {style}, 0, "0"
  for caption, panel in body:gmatch("(.-)(<svg .-</svg>)") do
    local x, y, width, height = panel:match(
      'x="([%d.]+)" y="([%d.]+)" width="([%d.]+)" height="([%d.]+)"')
    local _, lines = caption:gsub("<text", "")
    local box = table.concat({x, y, width, height + 18 * lines}, " ")
    table.insert(panels, '<svg class="tri" viewBox="' .. box .. '" width="' .. width ..
      '" height="' .. height + 18 * lines .. '">' .. caption .. panel .. "</svg>")
    if y == "14" then columns = columns + 1 end -- the first row
    widest = width
  end
  return table.concat(panels), columns, widest
end

-- A picture becomes part of the page.
function Para(para)
  local image = para.content[1]
  if #para.content ~= 1 or image.t ~= "Image" or not image.src:match("%.svg$") then
    return nil
  end
  local file = io.open(simplify(folder .. image.src))
  if not file then return nil end
  local svg = file:read("a")
  file:close()
  local panels, columns, width = panels_of(svg)
  local described = svg:match("<desc>(.-)</desc>"):gsub('"', "&quot;")
  return pandoc.RawBlock("html", '<figure style="--columns:' .. columns .. ";--width:" ..
    width .. 'px"><div role="img" aria-label="' .. described .. '">' .. panels ..
    "</div><figcaption>" .. pandoc.utils.stringify(image.caption) .. "</figcaption></figure>")
end

-- A table is as wide as it must be, and scrolls in its frame when that is too wide.
function Table(table)
  for _, column in ipairs(table.colspecs) do
    column[2] = nil
  end
  return pandoc.Div({table}, {class = #table.colspecs > 4 and "table wide" or "table"})
end

-- <!-- player: ARGUMENTS --> becomes a player of what `tri trace ARGUMENTS` prints. No
-- "<" may stand in it: "</script>" would end it.
local function player(arguments)
  local words = {"trace"}
  for word in arguments:gmatch("%S+") do table.insert(words, word) end
  local trace = pandoc.pipe(os.getenv("TRI"), words, ""):gsub("<", "\\u003c")
  return pandoc.RawBlock("html", '<div class="player"><script type="application/json">' ..
    trace .. "</script></div>")
end

-- The address of a quote becomes a line above it that leads to the source.
function RawBlock(block)
  local arguments = block.text:match("^<!%-%- player: (.-) %-%->")
  if arguments then return player(arguments) end
  if not block.text:match("^<!%-%- code:") then return nil end
  quoted = quoted + 1
  local quote = quotes[quoted]
  local link = relative(target(quote.path)) .. "#line-" .. quote.first
  return pandoc.RawBlock("html", '<p class="source"><a href="' .. link .. '">' ..
    quote.path .. "</a>, lines " .. quote.first .. " to " .. quote.last .. "</p>")
end
