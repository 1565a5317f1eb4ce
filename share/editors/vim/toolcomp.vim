" Vim compiler file: `:compiler toolcomp`, then `:make` runs the program, or checks the setup or case, in the buffer.
if exists('current_compiler')
  finish
endif
let current_compiler = 'toolcomp'
if exists(':CompilerSet') != 2
  command -nargs=* CompilerSet setlocal <args>
endif
if expand('%:e') ==? 'toml' || expand('%:e') ==? 'json'
  CompilerSet makeprg=toolcomp\ config\ check\ --color\ never\ %:S
else
  CompilerSet makeprg=toolcomp\ run\ --color\ never\ %:S\ >\ /dev/null
endif
CompilerSet errorformat=%f:%l:%v:\ %m,%f:%l:\ %m,%-G%.%#
