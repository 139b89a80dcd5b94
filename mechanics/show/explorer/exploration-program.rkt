#lang racket/base
;; An exploration written as a program that draws it again.

(require "exploration.rkt" "orbit-worker.rkt" "../plot/view.rkt")

(provide write-exploration names-missing)

;; source : the expression of the map, a datum, or #f if it is not known
;; picture : the name of the file that the program writes
;; missing : names in the source that the program lacks, or why the source is no expression
(define (write-exploration e v source picture port #:missing [missing '()])
  (define frame (frame-expression v (exploration-bounds e)))
  (for ([text (list opening (orbits->text e) (format redrawing frame)
                    (ending source picture missing))])
    (write-string text port)))

(define modules '(mechanics mechanics/book mechanics/plot))

;; -> a list of symbols, or a string, as unknown-names does
(define (names-missing source namespace)
  (if source (unknown-names source modules namespace) '()))

(define opening
  "#lang racket/base
;; Orbits of a map, as they were explored.

(require mechanics mechanics/book mechanics/plot)

(provide redraw)

;; Where each begins, how many images of that there are, and the number of its colour.
")

;; As much of each as there is: a start that has no image, or one further on that the map fails
;; for, would be an error where it is drawn again.
(define (orbits->text e)
  (define (orbit->text t)
    (define o (traced-orbit t))
    (format "\n        (list (up ~a ~a) ~a ~a)"
            (car (orbit-start o)) (cdr (orbit-start o)) (- (traced-count t) 1) (orbit-color o)))
  (format "(define orbits\n  (list~a))\n\n"
          (apply string-append
                 (for/list ([t (in-list (reverse (exploration-orbits e)))]
                            #:when (> (traced-count t) 0))
                   (orbit->text t)))))

(define redrawing
  "(define (redraw map)
  (define win ~s)
  (for ([o (in-list orbits)])
    (define-values (start n color) (apply values o))
    (explore-map win map n #:starts (list start) #:color color))
  win)
")

(define (ending source picture missing)
  (cond [(and source (pair? missing))
         (format "\n;; Here the following are not known; with them this draws it:~a\n#;\n~a"
                 (apply string-append (for/list ([name (in-list missing)]) (format " ~a" name)))
                 (main source picture))]
        [(and source (null? missing)) (string-append "\n" (main source picture))]
        [else
         (format "\n;; (graphics-save (redraw map) ~s) draws it, of the map that was explored.\n"
                 picture)]))

(define (main source picture)
  (format "(module+ main\n  (graphics-save (redraw ~s) ~s))\n" source picture))

(define (frame-expression v bounds)
  (define (given key value) (if value (list key value) '()))
  `(frame ,@bounds
          ,@(given '#:title (view-title v)) ,@(given '#:x-label (view-x-label v))
          ,@(given '#:y-label (view-y-label v))
          #:width ,(view-width v) #:height ,(view-height v)))

;; ---------------------------------------------------------------------------
;; The names of an expression that a program would not know, as Racket's own expander sees it: those
;; that the expression binds itself are known.

;; source : a datum; modules : those that the program requires, besides racket/base
;; namespace : where these modules are loaded or can be
;; -> a sorted list of symbols, or a string that says why the source is no expression
(define (unknown-names source modules namespace)
  (let look ([found '()])
    (define next (first-unknown source modules namespace found))
    (cond [(string? next) next]
          [(or (not next) (memq next found)) (sort found symbol<?)]
          [else (look (cons next found))])))

;; The expander reports one name at a time: names found so far are bound, and it runs again.
(define (first-unknown source modules namespace known)
  (define program
    (list #'module 'program 'racket/base
          (cons '#%require modules)
          (list 'lambda known (list 'lambda '() source))))
  (with-handlers ([exn:fail:syntax:unbound? name-of] [exn:fail:syntax? exn-message])
    (parameterize ([current-namespace namespace]
                   [current-load-relative-directory #f])
      (expand (datum->syntax #f program)))
    #f))

(define (name-of e)
  (define exprs (exn:fail:syntax-exprs e))
  (define name (and (pair? exprs) (syntax-e (car exprs))))
  (if (symbol? name) name (exn-message e)))
