#lang racket/base
;; The programs for the exercises of a chapter, and for those of Functional Differential Geometry,
;; listed by what their first lines say:
;;
;;   ;; Exercise 1.17 (SICM 1.6.2): a bead on a helical wire
;;   ;; Checked: the equation of motion in the angle about the axis
;;   ;; How: against a falling particle, with the wire as its coordinate

(require racket/file
         racket/list
         racket/runtime-path
         scribble/base
         (only-in "program.rkt" program-link))

(provide exercise-table geometry-exercise-table
         exercises geometry-exercises (struct-out exercise))

(define-runtime-path examples "../../examples/mechanics")

;; chapter, number : 1 and 17 for exercise 1.17.  section, subject, checked, how : strings
;; file : of the program, below the examples
(struct exercise (chapter number section subject checked how file) #:transparent)

;; ---------------------------------------------------------------------------
;; Reading

;; -> exercises of a chapter, by number
(define (exercises chapter)
  (read-exercises "exercises" (regexp (format "^exercise-~a-.*[.]rkt$" chapter))))

(define (geometry-exercises)
  (read-exercises "geometry/exercises" #rx"^FDG-exercise-.*[.]rkt$"))

(define (read-exercises folder name)
  (define (place e) (+ (* 1000 (exercise-chapter e)) (exercise-number e)))
  (sort (for/list ([file (in-list (directory-list (build-path examples folder)))]
                   #:when (regexp-match? name (path->string file)))
          (read-exercise (format "~a/~a" folder file)))
        < #:key place))

(define (read-exercise file)
  (define lines (file->lines (build-path examples file)))
  (define (line-that pattern line)
    (cond [(regexp-match pattern line) => cdr]
          [else (raise-arguments-error
                 'exercises "expected lines of the form `;; Exercise C.N (BOOK S): subject`, \
`;; Checked: ...` and `;; How: ...` after the language"
                 "file" file "line" line)]))
  (define heading
    (line-that #px"^;; Exercise (\\d+)[.](\\d+) \\((?:SICM|FDG) ([\\d.]+)\\): (.+)$"
               (list-ref lines 1)))
  (define checked (line-that #rx"^;; Checked: (.+)$" (list-ref lines 2)))
  (define how (line-that #rx"^;; How: (.+)$" (list-ref lines 3)))
  (exercise (string->number (first heading)) (string->number (second heading))
            (third heading) (fourth heading)
            (first checked) (first how) file))

;; ---------------------------------------------------------------------------
;; Showing

;; The pages of a section with all its parts; the exercises stand among its text.
(define pages
  (hash "1.3" "8–14" "1.4" "14–23" "1.5" "23–37" "1.6" "37–68"
        "1.7" "68–78" "1.8" "78–91" "1.9" "91–99"
        "2.10" "153–165" "2.11" "165–181" "2.12" "181–191"
        "3.1" "195–217" "3.2" "218–222" "3.4" "224–236" "3.5" "236–239"
        "3.6" "239–263" "3.9" "277–281"
        "5.1" "336–341" "5.2" "342–357" "5.3" "357–364" "5.4" "364–394"
        "5.5" "394–402" "5.6" "402–407" "5.8" "408–410"))

;; "1.6.2, in pp. 37–68", or no more than the section where the pages are not known.
(define (place e)
  (define section (exercise-section e))
  (define whole (car (regexp-match #rx"^[0-9]+([.][0-9]+)?" section)))
  (define range (hash-ref pages whole #f))
  (cond [(not range) section]
        [(string=? section whole) (string-append section ", pp. " range)]
        [else (string-append section ", in pp. " range)]))

(define (exercise-table chapter)
  (table '("" "Section" "What is checked, and how")
         (for/list ([e (in-list (exercises chapter))]) (list (link e) (place e) (what e)))))

(define (geometry-exercise-table)
  (table '("" "What is checked, and how")
         (for/list ([e (in-list (geometry-exercises))]) (list (link e) (what e)))))

(define (table heading rows)
  (tabular #:style 'boxed
           #:row-properties '(bottom-border)
           #:column-properties '(top)
           #:sep (hspace 2)
           (cons (map bold heading) rows)))

(define (link e)
  (program-link (exercise-file e) (format "~a.~a" (exercise-chapter e) (exercise-number e))))

(define (what e)
  (list (italic (capitalized (exercise-subject e))) ". "
        (capitalized (exercise-checked e)) ": " (exercise-how e) "."))

(define (capitalized text)
  (string-append (string-upcase (substring text 0 1)) (substring text 1)))
