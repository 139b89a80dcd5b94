#lang racket/base
;; The pages of big rooms: a folder of more than a dozen modules has a README.md with the modules
;; that other rooms require, its doors, and its helpers, a line for each:
;;
;;     ## Doors
;;     - `evolve.rkt`: motions of states, step by step
;;     ## Helpers
;;     - `step-size.rkt`: how long the next step is

(require racket/list
         racket/path
         racket/set
         racket/string)

(provide page-faults)   ; graph (graph.rkt), folder -> text of its page, or #f -> sentences

(define most-without-page 12)

(define (page-faults graph page-of)
  (define doors (list->set (doors-of graph)))
  (append*
   (for/list ([(folder names) (in-hash (group-by-folder (hash-keys graph)))]
              #:when (> (length names) most-without-page))
     (define page (page-of folder))
     (if page
         (faults-of folder page (sort (filter (lambda (n) (set-member? doors n)) names) string<?)
                    (sort (filter (lambda (n) (not (set-member? doors n))) names) string<?))
         (list (format "~a has ~a modules and no README.md" folder (length names)))))))

;; Returns the modules that a module of another folder requires.
(define (doors-of graph)
  (for*/list ([(name required) (in-hash graph)]
              [other (in-list required)]
              #:unless (equal? (folder-of name) (folder-of other)))
    other))

(define (faults-of folder page doors helpers)
  (define (check section expected)
    (define listed (sort (listed-under section page) string<?))
    (append (for/list ([name (in-list (remove* listed expected))])
              (format "~aREADME.md lacks ~a among its ~a" folder name section))
            (for/list ([name (in-list (remove* expected listed))])
              (format "~aREADME.md has ~a among its ~a" folder name section))))
  (define (base name) (path->string (file-name-from-path name)))
  (append (check "doors" (map base doors)) (check "helpers" (map base helpers))
          (for/list ([phrase (in-list (regexp-match* #px"(?m:^- `.*:$)" page))])
            (format "~aREADME.md breaks off: ~a" folder phrase))))

;; Returns the modules listed under the heading, up to the next heading.
(define (listed-under section page)
  (define after (regexp-match (format "(?i:\n## ~a\n)(.*)" section) (string-append "\n" page)))
  (define part (if after (car (regexp-split #rx"\n#" (cadr after))) ""))
  (map cadr (regexp-match* #rx"(?:^|\n)- `([^`]*)`: [^\n]" part #:match-select values)))

(define (group-by-folder names)
  (for/fold ([groups (hash)]) ([name (in-list names)])
    (hash-update groups (folder-of name) (lambda (l) (cons name l)) '())))

;; motion/event/event.rkt -> "motion/event/"; a facade -> ""
(define (folder-of name)
  (string-append* (map (lambda (part) (string-append part "/"))
                       (drop-right (string-split name "/") 1))))
