#lang racket/base
;; The search of the manual's pages finds what the prompt does, in the same order.

(require (for-label mechanics/lang/help/search-table)
         json
         mechanics/lang/help/cards
         mechanics/lang/help/finding
         mechanics/lang/help/search
         racket/file
         racket/list
         racket/port
         racket/runtime-path
         racket/system
         "../../../../scribblings/mechanics/look/search-data.rkt"
         "../../support/checks.rkt" "../../support/skip.rkt"
         "../../support/search-queries.rkt")

(define-runtime-path script "../../../../scribblings/mechanics/look/search.js")

(define texts
  (append (map car queries)
          '("a" "up" "UP" "F->C" "->TeX" "Poincaré" "Lagrange’s equation" "lagrange-equations"
            "what is a Lagrangian" "3.16" "equation 7.88" "equation 1.150" "quaternion homework"
            "simplif" "xyzzy" "moments of inertia matrices" "")))

(define misspelt '("pendulm" "hamiltonain equatons" "quaterion" "xyzzy" "pendulum"))

;; ---------------------------------------------------------------------------
;; At the prompt

(define (found text)
  (define-values (all fit?) (find-in-table (table-of-search) text))
  (list fit? (map finding-title all) (map finding-where all)))

;; ---------------------------------------------------------------------------
;; By the script

(define node (find-executable-path "node"))

(define program
  "const fs = require('fs'), [script, table, asked] = process.argv.slice(1);
   const search = require(script), all = JSON.parse(fs.readFileSync(table, 'utf8'));
   const { texts, misspelt } = JSON.parse(fs.readFileSync(asked, 'utf8'));
   console.log(JSON.stringify([
     texts.map(t => { const r = search.find(all, t);
                      return [r.all, r.found.map(f => f[1]), r.found.map(f => f[2])]; }),
     misspelt.map(t => search.respelled(all, t))]));")

(define (by-script)
  (define folder (make-temporary-file "search~a" 'directory))
  (define (written name x)
    (define file (build-path folder name))
    (call-with-output-file file (lambda (port) (write-json x port)))
    file)
  (define table (written "table.json" (search-data (lambda (f) "x.html"))))
  (define asked (written "asked.json" (hasheq 'texts texts 'misspelt misspelt)))
  (define answer
    (with-output-to-string
      (lambda () (system* node "-e" program (path->string script) table asked))))
  (delete-directory/files folder)
  (string->jsexpr answer))

(test-case "the script finds the same in the same order, and offers the same spelling"
  (skip-unless node "the search of the pages: node is not here"
    (define results (by-script))
    (for ([text (in-list texts)] [r (in-list (first results))])
      (check-equal? r (found text) text))
    (for ([text (in-list misspelt)] [r (in-list (second results))])
      (check-equal? (if (eq? r (json-null)) #f r) (respelled (table-of-search) text) text))))
